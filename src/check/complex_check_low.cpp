#include "check/complex_check_impl.hpp"

namespace delone::check_detail {

template std::size_t check_complex<1>(const ComplexInput&, Violations&);
template std::size_t check_complex<2>(const ComplexInput&, Violations&);
template std::size_t check_complex<3>(const ComplexInput&, Violations&);
template std::size_t check_complex<4>(const ComplexInput&, Violations&);

}  // namespace delone::check_detail
