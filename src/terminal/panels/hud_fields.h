#pragma once

#include <string>
#include <vector>

#include "terminal/panels/hud.h"

/// What the status lines say, as fields: which there are, their words, and which of them fit.
/// hud.cpp draws them.
namespace carom {

/// One item of a status line. Numbers keep their width while they change, so that the items behind
/// them do not move.
struct HudField {
    std::string label;
    std::string value;
    Ink ink;
    int rank = 0;  ///< the field of rank 0 is dropped last
};

/// Blank columns between two fields.
inline constexpr int hud_field_gap = 2;

int width_of(const HudField& field);
int width_of(const std::vector<HudField>& fields);

/// The fields that fit into `columns`, in their order; the least important are dropped first.
std::vector<HudField> fitting_fields(std::vector<HudField> fields, int columns);

/// `text` with blanks up to `width` columns.
std::string padded(std::string text, int width);

/// The state of play, for the first line: running or paused, the time, the solver, the speed. Of a
/// game only what is unusual.
std::vector<HudField> play_fields(const HudInfo& info, const Look& look);

/// What the level is about, expected values, energy and momentum, and last the model, if it fits.
std::vector<HudField> physics_fields(const HudInfo& info, int columns, const Look& look);

}  // namespace carom
