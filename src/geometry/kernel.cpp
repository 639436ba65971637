#include "delone/geometry/kernel.hpp"

namespace delone {

template class Kernel<4>;
template class Kernel<5>;
template class Kernel<6>;
template class Kernel<7>;
template class Kernel<8>;

}  // namespace delone
