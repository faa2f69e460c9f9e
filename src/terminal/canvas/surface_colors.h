#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "terminal/canvas/palette.h"

/// Which colours do the large areas of a picture get on a terminal of 256 colours?
namespace carom {

/// Two areas that touch, by their places in the list of colours.
using Neighbours = std::pair<std::size_t, std::size_t>;

/// The colours of areas that are seen together. 24-bit colours show as they are, and with fewer
/// than 256 each is that of ink_of_color().
///
/// 256 colours have few muted ones: the nearest to a dark green is teal, and to a brown grey. On a
/// small shape that passes; on a large area it changes what the area is. So the hue counts here
/// more than lightness and chroma, and a colour that is too vivid is better than a grey one. A
/// colour that is nearly grey itself has no such hue, and takes the nearest.
///
/// Areas that touch must not merge, nor differ much more than they should: what an area loses of
/// its difference from its neighbours, or gains, on average, counts as an error too. The choice
/// starts from the best colour of each, and changes one area at a time until none gets better.
///
/// Pre: look.has_colors(); both of each pair are less than wanted.size(). Cost: 240 for each area
/// and neighbour, a few times over.
std::vector<Color> surface_colors(std::span<const Rgb> wanted,
                                  std::span<const Neighbours> neighbours, const Look& look);

}  // namespace carom
