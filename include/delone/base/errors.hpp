// Three kinds of trouble, three ways: wrong input throws InputError, a wrong caller meets DELONE_ASSERT, and what
// geometry can bring about (a duplicate, a hidden point, flat input) is a value.
#pragma once

#include <stdexcept>
#include <string>

namespace delone {

/// The input is wrong; the message says what, where and what to do.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The caller's progress function asked to stop; the object is as it was before the call.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled by the caller") {}
};

}  // namespace delone
