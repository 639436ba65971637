// Keep a triangulation and get it back without building anew. Damage is noticed, whatever byte it hits.
#include <iostream>
#include <sstream>

#include "delone/delone.hpp"

int main() {
  const auto t = delone::triangulate<2>({{0, 0}, {5, 1}, {2, 4}, {-3, 2}, {1, 2}});
  std::stringstream file;
  delone::save(t, file);
  const delone::AnyTriangulation back = delone::load(file);
  std::cout << "the same: " << (delone::canonical_hash(t) == delone::canonical_hash(back) ? "yes" : "no") << '\n';

  std::string bytes = file.str();
  bytes[100] ^= 1;
  std::istringstream damaged(bytes);
  try {
    delone::load(damaged);
  } catch (const delone::InputError& error) {
    std::cout << "damaged: " << error.what() << '\n';
  }
}
