#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/scene/dress.h"

/// The colours that levels know by name.
namespace carom {

std::optional<Rgb24> color_named(std::string_view name);

/// All names, in the order of the manual.
std::vector<std::string_view> color_names();

/// A name, or #rrggbb in hexadecimal digits.
std::optional<Rgb24> color_of(std::string_view text);

/// Whether a text is of the form #rrggbb.
bool is_hex_color(std::string_view text);

/// The colour as `color=` takes it: its #rrggbb.
std::string color_text(Rgb24 color);

}  // namespace carom
