#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

/// Overlays: what a player can lay over the picture of a world, or under its bodies. An overlay is
/// a row of the table in overlays.cpp and a function there, and a row of the table of actions
/// (carom/controllers/action_table.cpp), which has its key and its help. What it needs to know
/// beyond the world is in Marks (draw.h).
namespace carom {

class Raster;
struct View;

struct Overlay {
    std::string_view name;       ///< of the action that turns it on and off
    std::string_view title;      ///< as a player reads it
    bool is_underneath = false;  ///< painted before the bodies
    void (*paint)(Raster& raster, const View& view) = nullptr;
};

/// In the order in which a player goes through them.
std::span<const Overlay> overlays();

/// Its place in the table. Pre: there is an overlay of that name.
std::size_t overlay_named(std::string_view name);

/// Which overlays are on, by their place in the table.
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
