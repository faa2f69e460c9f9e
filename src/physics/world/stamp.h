#pragma once

#include <cstdint>

namespace carom {

/// Names one state of some data: whoever changes the data gives it a new stamp. Equal stamps mean
/// equal data, so "has this changed since I last looked?" is one comparison. Stamps are never given
/// twice within a process, so two copies of a world that change separately never share one; a copy
/// that has not changed keeps the stamps of the original.
///
/// Stamps decide only whether work is repeated, never what comes of it: they are in no fingerprint,
/// and runs whose stamps differ give the same bits.
enum class Stamp : std::uint64_t {};

/// A stamp that no data has had yet. Safe to call from several threads.
Stamp new_stamp();

/// What a solver may have prepared in advance from a world, and when that changed last.
struct Stamps {
    Stamp definition{};  ///< Definition
    Stamp capsules{};    ///< Capsules
    /// Which balls there are, and all of their columns that no solver changes.
    Stamp roster{};
    Stamp motion{};  ///< the columns of Balls that a tick changes: position, velocity, spin ...
    /// SolverMemory: what the last solver left for its next tick.
    Stamp memory{};
    Stamp held{};  ///< held balls and held edges

    friend bool operator==(const Stamps&, const Stamps&) = default;
};

}  // namespace carom
