#include "physics/world/solver_memory.h"

#include <cstdint>

namespace carom {
namespace {

// Fingerprints of version 2 have these words, all 0, for a solver that remembers nothing: sizes of
// lists and numbers that the world itself once held.
constexpr int words_for_nothing = 9;

}  // namespace

SolverMemory& SolverMemory::operator=(const SolverMemory& other) {
    if (this == &other) return *this;
    if (held_ && !other.held_)
        held_->clear();
    else if (other.held_ && !(held_ && held_->assign(*other.held_)))
        held_ = other.held_->clone();
    return *this;
}

void SolverMemory::add_to(Hash& hash, const Model& model, int version) const {
    if (held_) return held_->add_to(hash, model, version);
    if (version == 1) return;
    for (int i = 0; i < words_for_nothing; ++i)
        hash.add(std::uint64_t{0});
}

}  // namespace carom
