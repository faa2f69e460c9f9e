#include <fmt/format.h>

#include <algorithm>

#include "lab/compare/compare.h"
#include "lab/json.h"
#include "lab/table.h"

namespace carom {
namespace {

using Layout = JsonWriter::Layout;

std::string named(const Choice& choice) {
    return fmt::format("{} at {:.6g} ticks a second",
                       settings_text(choice.solver, SettingsText::unusual), choice.rate);
}

std::string name_of(const Scene& scene, std::uint32_t ball) {
    return ball < scene.ball_names.size() ? scene.ball_names[ball] : std::string();
}

// "ball 3", or "ball 3 (cue)".
std::string ball_text(const Scene& scene, std::uint32_t ball) {
    const std::string name = name_of(scene, ball);
    return name.empty() ? fmt::format("ball {}", ball) : fmt::format("ball {} ({})", ball, name);
}

// The name of the body that the ball hits in the contact.
std::string partner_text(const Scene& scene, const Meeting& meeting, std::uint32_t ball) {
    if (meeting.kind == ContactKind::ball_edge) return fmt::format("edge {}", meeting.b);
    return ball_text(scene, meeting.a == ball ? meeting.b : meeting.a);
}

std::string side_text(const Scene& scene, const Choice& choice, std::uint32_t ball,
                      const std::optional<Meeting>& meeting) {
    const std::string what = meeting
                                 ? fmt::format("meets {} at {:.6g} s",
                                               partner_text(scene, *meeting, ball), meeting->time)
                                 : std::string("meets nothing any more");
    return fmt::format("  under {}: {}\n", named(choice), what);
}

std::string verdict(const Scene& scene, const Comparison& comparison) {
    if (!comparison.divergence) {
        const auto most = std::ranges::max_element(comparison.differences, {}, &DifferenceAt::max);
        return fmt::format(
            "They do not part within {:.6g} s: no ball is further than {:.2g} radii from its "
            "twin.\n",
            comparison.time(), most->max);
    }
    const Divergence& divergence = *comparison.divergence;
    return fmt::format(
        "They part after {:.6g} s: {} is {:.2g} radii from its twin, at {:.6g},{:.6g}.\n",
        divergence.time, ball_text(scene, number(divergence.ball)), divergence.distance,
        divergence.place.x, divergence.place.y);
}

std::string contact_text(const Scene& scene, const Comparison& comparison) {
    if (!comparison.contact) return "Every ball meets the same others in the same order.\n";
    const FirstDifference& contact = *comparison.contact;
    return fmt::format("The first contact that differs is of {}:\n{}{}",
                       ball_text(scene, contact.ball),
                       side_text(scene, comparison.first, contact.ball, contact.first),
                       side_text(scene, comparison.second, contact.ball, contact.second));
}

std::string growth_text(const Comparison& comparison) {
    if (!comparison.divergence) return {};
    if (!comparison.growth) return "The difference does not grow exponentially.\n";
    const Growth& growth = *comparison.growth;
    return fmt::format("The difference doubles every {:.3g} s (from {:.3g} to {:.3g} s).\n",
                       growth.doubling_time, growth.from, growth.to);
}

// About `most` of the differences, evenly spread, including the first and the last.
std::vector<DifferenceAt> thinned(const std::vector<DifferenceAt>& all, std::size_t most) {
    std::vector<DifferenceAt> some;
    const std::size_t last = all.size() - 1;
    const std::size_t shown = std::min(last, most - 1);
    for (std::size_t i = 0; i <= shown; ++i)
        some.push_back(all[shown == 0 ? 0 : last * i / shown]);
    return some;
}

std::string growth_table(const Comparison& comparison) {
    Table table({"time, s", "RMS, radii", "most"});
    for (const DifferenceAt& apart : thinned(comparison.differences, 17))
        table.add({fmt::format("{:.4g}", apart.time), fmt::format("{:.1e}", apart.rms),
                   fmt::format("{:.1e}", apart.max)});
    return table.text();
}

void write_choice(JsonWriter& json, std::string_view key, const Choice& choice) {
    json.key(key);
    json.begin_object(Layout::one_line);
    json.field("solver", name(choice.solver.kind));
    json.key("settings");
    write_settings(json, choice.solver);
    json.field("rate", choice.rate);
    json.end_object();
}

void write_divergence(JsonWriter& json, const Scene& scene, const Divergence& divergence) {
    json.begin_object(Layout::one_line);
    json.field("time", divergence.time);
    json.field("ball", std::uint64_t{number(divergence.ball)});
    json.field("name", std::string_view(name_of(scene, number(divergence.ball))));
    json.field("x", divergence.place.x);
    json.field("y", divergence.place.y);
    json.field("distance", divergence.distance);
    json.end_object();
}

void write_meeting(JsonWriter& json, std::string_view key, const std::optional<Meeting>& meeting) {
    json.key(key);
    if (!meeting) {
        json.null();
        return;
    }
    json.begin_object(Layout::one_line);
    json.field("time", meeting->time);
    json.field("kind", meeting->kind == ContactKind::ball_ball ? "ball_ball" : "ball_edge");
    json.field("a", std::uint64_t{meeting->a});
    json.field("b", std::uint64_t{meeting->b});
    json.end_object();
}

void write_contact(JsonWriter& json, const FirstDifference& contact) {
    json.begin_object(Layout::lines);
    json.field("time", contact.time);
    json.field("ball", std::uint64_t{contact.ball});
    write_meeting(json, "first", contact.first);
    write_meeting(json, "second", contact.second);
    json.end_object();
}

void write_growth(JsonWriter& json, const Growth& growth) {
    json.begin_object(Layout::one_line);
    json.field("doubling_time", growth.doubling_time);
    json.field("from", growth.from);
    json.field("to", growth.to);
    json.end_object();
}

}  // namespace

std::string compare_text(const Scene& scene, const Comparison& comparison) {
    return fmt::format(
        "{}: {}, and {}\n{}{}{}\n{}{}", scene.title.empty() ? scene.file : scene.title,
        named(comparison.first), named(comparison.second), verdict(scene, comparison),
        contact_text(scene, comparison), growth_text(comparison), growth_table(comparison),
        comparison.is_lost ? "There it ends: the two have nothing to do with each other any more.\n"
                           : "");
}

std::string compare_json(std::string_view level, const Scene& scene, const Comparison& comparison) {
    JsonWriter json;
    json.begin_object(Layout::lines);
    json.field("level", level);
    write_choice(json, "first", comparison.first);
    write_choice(json, "second", comparison.second);
    json.field("radius", comparison.radius);
    json.field("tolerance", comparison.tolerance);
    json.field("time", comparison.time());
    json.key("parting");
    if (comparison.divergence) {
        write_divergence(json, scene, *comparison.divergence);
    } else {
        json.null();
    }
    json.key("contact");
    if (comparison.contact) {
        write_contact(json, *comparison.contact);
    } else {
        json.null();
    }
    json.key("growth");
    if (comparison.growth) {
        write_growth(json, *comparison.growth);
    } else {
        json.null();
    }
    json.key("differences");
    json.begin_list(Layout::lines);
    for (const DifferenceAt& apart : thinned(comparison.differences, 1000)) {
        json.begin_object(Layout::one_line);
        json.field("time", apart.time);
        json.field("rms", apart.rms);
        json.field("max", apart.max);
        json.end_object();
    }
    json.end_list();
    json.end_object();
    return std::move(json).text();
}

}  // namespace carom
