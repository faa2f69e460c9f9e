#pragma once

#include <string>

/// Numbers as text for tables.
namespace carom::bench {

/// Three significant digits, without an exponent from 0.001 to a million: 0.0431, 3.53, 1,240,000.
std::string figure(double value);

/// Two significant digits with an exponent where it is small: 0, 3e-05, 0.21.
std::string small_figure(double value);

/// A relative change: -37 %, 1e-13.
std::string change(double value);

/// Grouped by thousands: 10,000.
std::string grouped(double value);

}  // namespace carom::bench
