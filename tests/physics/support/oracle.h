#pragma once

#include <gmpxx.h>

#include "lab/measure/oracle.h"

/// The oracle of `carom measure` with 96 digits, against which `event` is tested. Built if Debian's
/// libgmp-dev is installed.
inline mpf_class sqrt_of(const mpf_class& x) {
    return mpf_class(sqrt(x));
}
inline int sign_of(const mpf_class& x) {
    return sgn(x);
}
inline double double_of(const mpf_class& x) {
    return x.get_d();
}

namespace carom::many_digits {

using Number = mpf_class;
using Point = oracle::Point<Number>;
using Oracle = oracle::Oracle<Number>;

/// The precision of numbers created from here on: 320 bits, 96 digits.
inline void use() {
    mpf_set_default_prec(320);
}

}  // namespace carom::many_digits
