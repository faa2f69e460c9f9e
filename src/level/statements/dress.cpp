#include <fmt/format.h>

#include <array>
#include <utility>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/statements/device_parts.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"
#include "level/text/joined.h"
#include "level/text/spelling.h"

/// Statements that only say how a level looks: paint, label, insert and theme.
namespace carom {
namespace {

// Counts corners of areas, circles and labels against the limit.
void reserve_paint(std::size_t points, const Span& at, Context& context) {
    context.ir.painted_points += points;
    if (context.ir.painted_points <= max_painted_points) return;
    context.reporter.stop(
        "too-much-paint", at,
        fmt::format("the painted areas and labels have more than {} points", max_painted_points),
        "paint fewer of them");
}

void paint_corners(const std::vector<Vec2>& corners, const Arguments& arguments, const Frame& frame,
                   Context& context) {
    reserve_paint(corners.size(), arguments.node->keyword().span(), context);
    PaintedArea area;
    for (const Vec2 corner : corners)
        area.corners.push_back(frame.transform.point(corner));
    area.color = arguments.color().value_or(0);
    area.layer = static_cast<std::uint8_t>(arguments.number_or("layer", 0.0));
    context.ir.areas.push_back(std::move(area));
}

void paint_polygon(const Arguments& arguments, const Frame& frame, Context& context) {
    paint_corners(arguments.points, arguments, frame, context);
}

void paint_rect(const Arguments& arguments, const Frame& frame, Context& context) {
    const Vec2 a = arguments.points[0];
    const Vec2 b = arguments.points[1];
    paint_corners({a, {b.x, a.y}, b, {a.x, b.y}}, arguments, frame, context);
}

void paint_circle(const Arguments& arguments, const Frame& frame, Context& context) {
    reserve_paint(1, arguments.node->keyword().span(), context);
    PaintedArea area;
    area.disc = {frame.transform.point(arguments.pair_or("at", {})), arguments.number_or("r", 0.0)};
    area.color = arguments.color().value_or(0);
    area.layer = static_cast<std::uint8_t>(arguments.number_or("layer", 0.0));
    context.ir.areas.push_back(std::move(area));
}

// The text of a word in quotes; reports one without.
std::optional<std::string> quoted_text(const Word& word, Context& context) {
    const std::string_view text = word.text;
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return printable(text.substr(1, text.size() - 2));
    context.reporter.error("text-without-quotes", word.span(), "the text stands in quotes",
                           fmt::format("write \"{}\"", printable(text)));
    return std::nullopt;
}

// The value of a key that takes one of a few words; `otherwise` where the key is absent.
template <typename Value, std::size_t count>
std::optional<Value> one_of(const std::array<std::pair<std::string_view, Value>, count>& words,
                            std::string_view key, Value otherwise, FaultCode code,
                            const Arguments& arguments, Context& context) {
    const std::optional<Word> word = arguments.word(key);
    if (!word) return otherwise;
    std::vector<std::string_view> known;
    for (const auto& [name, value] : words) {
        if (name == word->text) return value;
        known.push_back(name);
    }
    context.reporter.error(
        code, word->span(), fmt::format("{}= is not '{}'", key, word->text),
        did_you_mean(word->text, known, fmt::format("there are: {}", joined(known, " "))));
    return std::nullopt;
}

void add_label(const Arguments& arguments, const Frame& frame, Context& context) {
    using enum BoardLabel::Align;
    constexpr std::array<std::pair<std::string_view, BoardLabel::Align>, 3> aligns{
        {{"center", center}, {"left", left}, {"right", right}}};
    const auto text = quoted_text(arguments.plain.front(), context);
    const auto align = one_of(aligns, "align", center, "unknown-align", arguments, context);
    if (!text || !align) return;
    reserve_paint(1, arguments.node->keyword().span(), context);
    context.ir.labels.push_back(
        {*text, frame.transform.point(arguments.pair_or("at", {})), *align, arguments.color()});
}

// An insert is a lamp with a shape.
void build_insert(const Arguments& arguments, const Frame& frame, Context& context) {
    using enum InsertShape;
    constexpr std::array<std::pair<std::string_view, InsertShape>, 7> shapes{
        {{"circle", circle},
         {"arrow", arrow},
         {"triangle", triangle},
         {"square", square},
         {"diamond", diamond},
         {"star", star},
         {"bar", bar}}};
    const auto shape = one_of(shapes, "shape", circle, "unknown-shape", arguments, context);
    if (!shape) return;
    DeviceDress dress{.color = arguments.color(), .is_insert = true, .shape = *shape};
    dress.radius = arguments.number_or("r", default_size(0.012, 1.0, context));
    const SinCos turn = sin_cos_degrees(arguments.number_or("turn", 90.0));
    dress.direction = frame.transform.direction({turn.cos, turn.sin});
    Arguments names = arguments;
    if (!names.plain.empty() && names.plain.back().text.starts_with('"')) {
        const auto text = quoted_text(names.plain.back(), context);
        if (!text) return;
        dress.text = *text;
        names.plain.pop_back();
    }
    if (names.plain.size() > 1) {
        quoted_text(names.plain.back(), context);
        return;
    }
    const int binding = bind_device(names, std::nullopt, context);
    // One name for all of them, at the one in the middle.
    const std::string text = std::exchange(dress.text, "");
    for (std::size_t i = 0; i < arguments.places.size(); ++i) {
        dress.text = i == arguments.places.size() / 2 ? text : "";
        DeviceIr device{.device = {.kind = DeviceKind::lamp},
                        .binding = binding,
                        .origin = origin_of(arguments, frame),
                        .dress = dress};
        device.device.place = frame.transform.point(arguments.places[i]);
        add_device(std::move(device), context);
    }
}

void set_theme(const Arguments& arguments, const Frame&, Context& context) {
    context.ir.theme = {arguments.color("board"), arguments.color("rail"), arguments.color("edge")};
}

}  // namespace

std::vector<Statement> dress_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto length = Measure::length;
    constexpr auto number = Measure::number;
    const KeyRule required_color{"color", color, number, any, true};
    const KeyRule above{"layer", scalar, Measure::whole, layer};
    return {
        {.name = "paint polygon",
         .usage = "paint polygon X,Y X,Y X,Y ... color= [layer=0..3]",
         .action = paint_polygon,
         .points_least = 3,
         .points_most = many,
         .keys = {required_color, above}},
        {.name = "paint rect",
         .usage = "paint rect X0,Y0 X1,Y1 color= [layer=0..3]",
         .action = paint_rect,
         .points_least = 2,
         .points_most = 2,
         .keys = {required_color, above}},
        {.name = "paint circle",
         .usage = "paint circle at=X,Y r= color= [layer=0..3]",
         .action = paint_circle,
         .keys = {keys::at, {"r", scalar, length, positive, true}, required_color, above}},
        {.name = "label",
         .usage = "label \"TEXT\" at=X,Y [align=center|left|right] [color=]",
         .action = add_label,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {keys::at, {"align", word}, keys::color}},
        {.name = "insert",
         .usage = "insert [NAME] [\"TEXT\"] at=X,Y ... "
                  "[shape=circle|arrow|triangle|square|diamond|star|bar] [r=] [turn=ANGLE] "
                  "[color=]",
         .action = build_insert,
         .plain_most = 2,
         .keys = {keys::places,
                  {"shape", word},
                  {"r", scalar, length, positive},
                  {"turn", scalar, Measure::angle},
                  keys::color},
         .binds_names = true},
        {.name = "theme",
         .usage = "theme [board=COLOR] [rail=COLOR] [edge=COLOR]",
         .action = set_theme,
         .place = Place::top,
         .keys = {{"board", color}, {"rail", color}, {"edge", color}},
         .is_unique = true,
         .settable = Settable::whole},
    };
}

}  // namespace carom
