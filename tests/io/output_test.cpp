#include "io/output.hpp"

#include "io/files.hpp"
#include "io/source.hpp"

namespace delone::io {
namespace {

TEST(Output, long_texts_go_out_between_short_ones) {
  const Directory directory;
  std::string text(std::size_t{5} << 19, '.');
  for (std::size_t i = 0; i < text.size(); i += 997) text[i] = static_cast<char>('a' + i % 26);
  for (const std::string name : {"a.txt", "a.txt.gz"}) {
    Output output(directory / name);
    output << "before " << text << " between " << text;
    output.commit();
    EXPECT_TRUE(Source::read(directory / name).bytes() == "before " + text + " between " + text) << name;
  }
}

TEST(Output, arrays_are_the_bytes_of_their_numbers) {
  const Directory directory;
  const std::vector<std::uint32_t> numbers{1, 0x01020304, 0xFFFFFFFF};
  Output output(directory / "a");
  output.put_all<std::int32_t>(numbers);
  output.put_all<std::int64_t>(numbers);
  output.put_all<double>(Doubles{1});
  output.commit();
  EXPECT_EQ(contents(directory / "a"), std::string("\1\0\0\0\4\3\2\1\xff\xff\xff\xff"
                                                   "\1\0\0\0\0\0\0\0\4\3\2\1\0\0\0\0\xff\xff\xff\xff\0\0\0\0"
                                                   "\0\0\0\0\0\0\xf0\x3f",
                                                   44));
}

}  // namespace
}  // namespace delone::io
