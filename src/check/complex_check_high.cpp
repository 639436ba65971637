#include "check/complex_check_impl.hpp"

namespace delone::check_detail {

template std::size_t check_complex<5>(const ComplexInput&, Violations&);
template std::size_t check_complex<6>(const ComplexInput&, Violations&);
template std::size_t check_complex<7>(const ComplexInput&, Violations&);
template std::size_t check_complex<8>(const ComplexInput&, Violations&);

}  // namespace delone::check_detail
