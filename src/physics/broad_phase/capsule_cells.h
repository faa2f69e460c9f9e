#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broad_phase/cell_frame.h"
#include "physics/world/world.h"

namespace carom {

/// A capsule that reaches into a cell; on a torus, with its periodic image index: by how many
/// widths and heights of the torus it is shifted.
struct CapsuleEntry {
    std::uint32_t index = 0;
    std::int8_t across = 0;
    std::int8_t along = 0;
};

/// The edges in the cells of a frame. They are kept as long as a comparison finds frame and
/// capsules unchanged. If a few capsules have changed, such as flippers that come to rest, only
/// these are removed and inserted again; otherwise everything is rebuilt.
class CapsuleCells {
  public:
    /// Each capsule enters the cells that it reaches when grown by `margin`. Held capsules are left
    /// out.
    void update(const World& world, const CellFrame& frame, double margin);

    /// Updates with the frame and margin of the last `update`. Does nothing and returns false if
    /// the world has another number of capsules now, or if so many have changed that building anew
    /// is cheaper.
    bool mend(const World& world);

    /// Capsules of one cell, ascending.
    std::span<const CapsuleEntry> in_cell(std::uint32_t cell) const {
        if (is_empty(cell)) return {};
        const std::size_t at = words_[cell / 64].before + before_[cell];
        return std::span(entries_).subspan(start_[at], start_[at + 1] - start_[at]);
    }

    /// Whether the cell has none. Reads less memory than `in_cell`.
    bool is_empty(std::uint32_t cell) const {
        return (words_[cell / 64].is_occupied >> (cell % 64) & 1u) == 0;
    }

    /// The cells that have any, ascending.
    std::span<const std::uint32_t> occupied() const { return occupied_; }

  private:
    /// Of 64 cells.
    struct Word {
        std::uint64_t is_occupied = 0;  ///< a bit for each
        std::uint32_t before = 0;       ///< occupied cells before these
    };
    /// An entry that is to be put in.
    struct Newcomer {
        std::uint32_t cell = 0;
        CapsuleEntry entry;
    };
    template <typename Visit>
    void for_each_cell(const Capsule& shape, Visit&& visit) const;
    template <typename Visit>
    void for_each_place(const World& world, std::uint32_t capsule, Visit&& visit) const;
    void build(const World& world);
    void note_held(const World& world);
    void note_changes(const World& world);
    void put_in_again(const World& world);
    void sort_newcomers();
    void mark_occupied();

    CellFrame frame_;
    double margin_ = -1.0;
    std::vector<Capsule> shapes_;      // as they are in the cells
    std::vector<std::uint32_t> out_;   // in no cell, being held; ascending
    std::vector<std::uint32_t> held_;  // now
    // Few cells have any edge, so only these have entries: where those of the k-th begin.
    std::vector<std::uint32_t> occupied_;
    std::vector<std::uint32_t> start_;
    std::vector<CapsuleEntry> entries_;
    std::vector<Word> words_;
    std::vector<std::uint8_t> before_;  // by cell: occupied ones before it among the 64
    // While capsules are put in again.
    std::vector<std::uint32_t> changed_;
    std::vector<Newcomer> newcomers_;
    std::vector<Newcomer> sorted_;
    std::vector<std::uint32_t> new_occupied_;
    std::vector<std::uint32_t> new_start_;
    std::vector<CapsuleEntry> new_entries_;
};

}  // namespace carom
