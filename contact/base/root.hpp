// Bracketed roots of functions of one variable.
#pragma once

#include <functional>

namespace rollfem::contact {

/// Where `f` passes zero between `a` and `b`, at which its values differ in sign or vanish: within
/// `tolerance` of the argument, or to its last digits where they are coarser. Where `f` jumps past
/// zero that place counts. Throws SolveError that begins with `what` ("roll of the wheelset") when
/// the signs are equal or a value is not finite.
double bracketed_root(const std::function<double(double)>& f, double a, double b, double tolerance,
                      const char* what);

}  // namespace rollfem::contact
