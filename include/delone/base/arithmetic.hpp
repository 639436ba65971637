// The floating-point environment that error bounds rest on: noticed when it is wrong, set right for the time of a call.
#pragma once

#include <string>
#include <vector>

namespace delone {

/// Sets rounding to nearest and keeps denormals for its lifetime, then restores what the caller had. Every public call
/// that decides signs opens one, so predicates are right whatever mode the caller left.
class ExactEnvironment {
 public:
  ExactEnvironment();
  ~ExactEnvironment();
  ExactEnvironment(const ExactEnvironment&) = delete;
  ExactEnvironment& operator=(const ExactEnvironment&) = delete;

 private:
  unsigned saved_;
};

/// What is wrong with the arithmetic of this build or this thread: contraction of a*b-c*d to fused multiply-add, a
/// changed rounding mode, flushed denormals, excess precision. Empty when all is well; one sentence each otherwise.
std::vector<std::string> arithmetic_problems();

}  // namespace delone
