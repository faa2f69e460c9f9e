#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/assemble/resolve_names.h"
#include "level/text/reporter.h"
#include "level/text/spelling.h"
#include "physics/world/world.h"

/// The names of kinds and materials, and which of them collide.

namespace carom {

/// Finds the kinds or the materials of a level by name, and records which are used. The default
/// class, for balls or edges without a class name, has the index after the last name.
class ClassNames {
  public:
    explicit ClassNames(const std::vector<std::string_view>& names) : used_(names.size(), false) {
        for (std::size_t i = 0; i < names.size(); ++i)
            index_.emplace(names[i], i);
    }

    std::optional<ClassIndex> find(std::string_view name) {
        const auto found = index_.find(name);
        if (found == index_.end()) return std::nullopt;
        used_[found->second] = true;
        return static_cast<ClassIndex>(found->second);
    }
    bool has(std::string_view name) const { return index_.contains(name); }
    /// The default class, for balls or edges without a class name.
    ClassIndex default_class() {
        is_default_used_ = true;
        return static_cast<ClassIndex>(used_.size());
    }
    bool is_default_used() const { return is_default_used_; }
    bool is_used(std::size_t i) const { return used_[i]; }

  private:
    std::map<std::string_view, std::size_t> index_;
    std::vector<bool> used_;
    bool is_default_used_ = false;
};

/// did_you_mean() for the first errors of a level; `otherwise` for later ones, since searching for
/// a similar name takes time.
inline std::string suggestion(std::string_view word, const std::vector<std::string_view>& known,
                              std::string otherwise, const Reporter& reporter) {
    if (reporter.errors() > 10 * max_diagnostics) return otherwise;
    return did_you_mean(word, known, std::move(otherwise));
}

/// The collision matrix of kinds and materials (ResolvedNames::collision_matrix), from the
/// `collide` statements and the layers of a level; empty: all collide. Reports unknown and
/// ambiguous names, and statements that make edges collide with edges. Pre: `names` has its kinds,
/// materials and layers; each layer has `kinds_of_a_layer` kinds.
std::vector<std::uint8_t> make_collision_matrix(const LevelIr& ir, const ResolvedNames& names,
                                                std::size_t kinds_of_a_layer, ClassNames& kinds,
                                                ClassNames& materials, Reporter& reporter);

}  // namespace carom
