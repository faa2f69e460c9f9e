#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/cell_frame.h"
#include "physics/world.h"

/// The edges in the cells of the broad phase.
namespace carom {

/// A capsule that reaches into a cell; on a torus the image of it that does, moved by whole tori.
struct CapsuleEntry {
    std::uint32_t index = 0;
    std::int8_t across = 0;
    std::int8_t along = 0;
};

/// Built once and kept while frame and capsules stay as they are (compared, not trusted).
class CapsuleCells {
  public:
    /// Each capsule enters the cells that it reaches when grown by `margin`. Held capsules are left
    /// out.
    void update(const World& world, const CellFrame& frame, double margin);

    /// Capsules of one cell, ascending.
    std::span<const CapsuleEntry> in_cell(std::uint32_t cell) const {
        return std::span(entries_).subspan(start_[cell], start_[cell + 1] - start_[cell]);
    }

    /// The cells that have any, ascending.
    std::span<const std::uint32_t> occupied() const { return occupied_; }

  private:
    bool is_current(const World& world, const CellFrame& frame, double margin) const;
    template <typename Visit>
    void for_each_cell(const Capsule& shape, Visit&& visit) const;

    CellFrame frame_;
    double margin_ = -1.0;
    std::vector<Capsule> shapes_;
    std::vector<CapsuleId> held_;
    std::vector<std::uint32_t> start_;
    std::vector<CapsuleEntry> entries_;
    std::vector<std::uint32_t> occupied_;
};

/// Whether a hand holds the capsule.
bool is_held(const World& world, CapsuleId id);

}  // namespace carom
