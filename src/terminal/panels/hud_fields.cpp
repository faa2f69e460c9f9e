#include "terminal/panels/hud_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "level/text/joined.h"
#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {

int width_of(const HudField& field) {
    const int label = columns_of(field.label);
    return label + (label > 0 ? 1 : 0) + columns_of(field.value);
}

int width_of(const std::vector<HudField>& fields) {
    int width = -hud_field_gap;
    for (const HudField& field : fields)
        width += width_of(field) + hud_field_gap;
    return width;
}

std::vector<HudField> fitting_fields(std::vector<HudField> fields, int columns) {
    while (!fields.empty() && width_of(fields) > columns) {
        fields.erase(
            std::max_element(fields.begin(), fields.end(),
                             [](const HudField& a, const HudField& b) { return a.rank < b.rank; }));
    }
    return fields;
}

std::string padded(std::string text, int width) {
    const int missing = width - columns_of(text);
    if (missing > 0) text.append(static_cast<std::size_t>(missing), ' ');
    return text;
}

namespace {

// Five digits, whatever the magnitude.
std::string quantity(double value) {
    return fmt::format("{:<10.5g}", value);
}

// A component that is only rounding of the other is shown as 0.
std::string momentum(Vec2 p) {
    const double noise = 1e-9 * std::max(std::abs(p.x), std::abs(p.y));
    const auto component = [&](double value) { return std::abs(value) < noise ? 0.0 : value; };
    return fmt::format("{:<+9.3g} {:<+9.3g}", component(p.x), component(p.y));
}

std::string duration(double seconds) {
    if (std::abs(seconds) < 1e5) return fmt::format("{:>9.3f} s", seconds);
    return fmt::format("{:>9.5g} s", seconds);
}

std::string factor(double speed) {
    return fmt::format("x{:<5.3g}", speed);
}

HudField drift_field(std::string_view label, double drift, int rank, const Look& look) {
    const double size = std::abs(drift);
    const Role role = size < 1e-9 ? Role::good : size < 1e-3 ? Role::text : Role::warning;
    std::string text = drift == 0.0 ? "0" : fmt::format("{:+.1e}", drift);
    return {std::string(label), padded(std::move(text), 8), ink_of(role, look), rank};
}

// "2817 of 3141", "5.9871, expected 6", "0.4 < 0.5": green once the value is as expected.
HudField check_field(const HudCheck& check, int rank, const Look& look) {
    const std::string value =
        check.is_exact ? fmt::format("{:.8g}", check.value) : fmt::format("{:.5g}", check.value);
    const std::string measured = check.is_exact ? fmt::format("{:.8g}", check.measured)
                                                : fmt::format("{:.5g}", check.measured);
    const int width = check.is_exact ? columns_of(value) : std::max(7, columns_of(value));
    // A measured value is no share of the expected one, as a count is.
    const std::string relation = check.relation == "of" && !check.is_exact
                                     ? ", expected"
                                     : fmt::format(" {}", check.relation);
    std::string name = check.quantity;
    std::ranges::replace(name, '_', ' ');
    return {std::move(name), fmt::format("{:>{}}{} {}", measured, width, relation, value),
            ink_of(check.holds ? Role::good : Role::text, look), rank};
}

// The state of play: running or paused, how fast, and how far back.
HudField state_field(const HudInfo& info, const Look& look) {
    if (info.is_paused) {
        const std::string_view sign = look.utf8 ? "‖ " : "|| ";
        return {"", fmt::format("{}paused", sign), ink_of(Role::warning, look), 0};
    }
    const std::string_view sign = look.utf8 ? "▸ " : "> ";
    return {"", fmt::format("{}{:<6}", sign, factor(info.speed)), ink_of(Role::good, look), 0};
}

// Of a game: whether it runs, what is unusual about it, and its goal, where the second line has
// other things to say.
std::vector<HudField> game_fields(const HudInfo& info, const Look& look) {
    std::vector<HudField> fields;
    if (!info.game.empty() && !info.goal.empty())
        fields.push_back({"", info.goal, ink_of(Role::warning, look), 4});
    if (info.is_paused || info.speed != 1.0) fields.push_back(state_field(info, look));
    if (info.latest_tick > info.tick)
        fields.push_back({"", duration(info.time), ink_of(Role::text, look), 1});
    if (!info.mode.empty()) fields.push_back({"", info.mode, ink_of(Role::warning, look), 2});
    return fields;
}

// Energy, momentum and what the level expects.
std::vector<HudField> measured_fields(const HudInfo& info, int columns, const Look& look) {
    const Ink text = ink_of(Role::text, look);
    std::vector<HudField> fields;
    const std::string& first = info.beside.empty() ? info.goal : info.beside;
    if (!first.empty())
        fields.push_back({"", shortened(first, columns, look), ink_of(Role::warning, look), -1});
    int rank = 1;
    bool has_collisions = false;
    for (const HudCheck& check : info.checks) {
        fields.push_back(check_field(check, rank, look));
        rank = 8;
        has_collisions = has_collisions || check.quantity == "collisions";
    }
    if (!has_collisions) {
        fields.push_back({"collisions", fmt::format("{:<8}", info.collisions), text, 5});
    }
    fields.push_back({"KE", quantity(info.kinetic_energy), text, 0});
    if (info.potential_energy) {
        fields.push_back({"PE", quantity(*info.potential_energy), text, 6});
    }
    if (info.energy_drift) fields.push_back(drift_field("drift", *info.energy_drift, 2, look));
    fields.push_back({"p", momentum(info.momentum), text, 4});
    if (info.momentum_drift) fields.push_back(drift_field("drift", *info.momentum_drift, 7, look));
    return fields;
}

// The model in force: its terms, or their names, or as many names as fit.
HudField model_field(const HudInfo& info, int columns, const Look& look) {
    HudField field{"model", "free discs", ink_of(Role::text, look), 3};
    if (info.terms.empty()) return field;
    field.value = fmt::format("{}", joined(info.terms, ", "));
    std::vector<std::string> names;
    for (const std::string& term : info.terms)
        names.push_back(term.substr(0, term.find(' ')));
    for (std::size_t left_out = 0; width_of(field) > columns && !names.empty(); ++left_out) {
        if (left_out > 0) names.pop_back();
        field.value = joined(names, ", ");
        if (left_out > 0) field.value += fmt::format(" +{}", left_out);
    }
    return field;
}

}  // namespace

std::vector<HudField> play_fields(const HudInfo& info, const Look& look) {
    if (info.is_game) return game_fields(info, look);
    const Ink text = ink_of(Role::text, look);
    std::vector<HudField> fields;
    fields.push_back(state_field(info, look));
    fields.push_back({"", duration(info.time), text, 1});
    std::string tick = fmt::format("{}", info.tick);
    if (info.latest_tick > info.tick) tick += fmt::format("/{}", info.latest_tick);
    fields.push_back({"tick", padded(std::move(tick), 7), text, 5});
    fields.push_back({"", info.solver + (info.solver_is_picked ? " (auto)" : ""),
                      ink_of(Role::strong, look), 2});
    if (info.solver_is_picked && !info.reason.empty())
        fields.push_back({"", info.reason, ink_of(Role::faint, look), 9});
    const bool is_late = !info.is_paused && info.ticks_per_second < 0.9 * info.rate * info.speed;
    fields.push_back({"", fmt::format("{:>5.0f}/{:.0f} ticks/s", info.ticks_per_second, info.rate),
                      is_late ? ink_of(Role::warning, look) : text, 3});
    fields.push_back({"balls", fmt::format("{:<5}", info.balls), text, 4});
    if (info.clustered > 0)
        fields.push_back({"", fmt::format("{} of {} under contact", info.clustered, info.balls),
                          ink_of(Role::warning, look), 3});
    if (!info.mode.empty()) fields.push_back({"", info.mode, text, 6});
    return fields;
}

std::vector<HudField> physics_fields(const HudInfo& info, int columns, const Look& look) {
    constexpr int least_model = 22;
    std::vector<HudField> fields = measured_fields(info, columns, look);
    fields.push_back(model_field(info, least_model, look));
    fields = fitting_fields(std::move(fields), columns);
    if (!fields.empty() && fields.back().label == "model") {
        const int others = width_of(fields) - width_of(fields.back());
        fields.back() = model_field(info, columns - others, look);
    }
    return fields;
}

}  // namespace carom
