#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "terminal/canvas/camera.h"

/// Overlays are drawn over the picture of a world, or under its bodies. An overlay is a row of the
/// table in overlays.cpp, a function there, and a row in the table of actions
/// (carom/controllers/action_table.cpp), which has its key and its help. Data that it needs beyond
/// the world comes in Annotations (draw.h).
namespace carom {

class Raster;
struct View;

struct Overlay {
    std::string_view name;       ///< of the action that turns the overlay on and off
    std::string_view title;      ///< shown to a player
    bool is_underneath = false;  ///< painted before the bodies
    void (*paint)(Raster& raster, const View& view) = nullptr;
};

/// All overlays, in the order in which a player cycles through them.
std::span<const Overlay> overlays();

/// Whether lines so far apart, in lengths of the world, are drawn: closer ones would hide the
/// picture.
bool has_room_for_grid(const Camera& camera, double spacing);

/// The index of an overlay in the table. Pre: there is an overlay of that name.
std::size_t overlay_named(std::string_view name);

/// The overlays that are on, by their index in the table.
class OverlaySet {
  public:
    static constexpr std::size_t most = 16;  ///< rows of the table

    bool& operator[](std::size_t overlay) { return is_on_[overlay]; }
    bool operator[](std::size_t overlay) const { return is_on_[overlay]; }

    friend bool operator==(const OverlaySet&, const OverlaySet&) = default;

  private:
    std::array<bool, most> is_on_{};
};

}  // namespace carom
