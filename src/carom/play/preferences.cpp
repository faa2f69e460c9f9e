#include "carom/play/preferences.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <functional>

#include "carom/files/files.h"
#include "carom/files/user_folders.h"
#include "carom/text/suggest.h"
#include "game/ai/person_hand.h"
#include "level/text/joined.h"
#include "terminal/canvas/character_width.h"

namespace carom {
namespace {

template <typename T>
struct Named {
    std::string_view name;
    T value;
};

constexpr Named<ColorChoice> color_choices[] = {
    {"auto", ColorChoice::automatic}, {"mono", ColorChoice::mono},
    {"8", ColorChoice::c8},           {"16", ColorChoice::c16},
    {"256", ColorChoice::c256},       {"truecolor", ColorChoice::direct}};
constexpr Named<std::optional<bool>> backgrounds[] = {
    {"auto", std::nullopt}, {"dark", false}, {"light", true}};
constexpr Named<bool> switches[] = {{"on", true}, {"off", false}};
constexpr Named<ColorBy> color_bys[] = {{"kind", ColorBy::kind},
                                        {"speed", ColorBy::speed},
                                        {"mass", ColorBy::mass},
                                        {"ball", ColorBy::ball}};
constexpr Named<BallStyle> ball_styles[] = {{"filled", BallStyle::filled},
                                            {"outline", BallStyle::outline}};

template <typename T, std::size_t n>
std::string_view name_in(const Named<T> (&table)[n], T value) {
    for (const Named<T>& row : table)
        if (row.value == value) return row.name;
    return {};
}

/// The error in a value; none if it was accepted.
using Wrong = std::optional<std::string>;

template <typename T, std::size_t n, typename Target>
Wrong choose(const Named<T> (&table)[n], std::string_view text, Target& target) {
    std::string all;
    for (const Named<T>& row : table) {
        if (row.name == text) {
            target = row.value;
            return std::nullopt;
        }
        all += (all.empty() ? "" : ", ") + std::string(row.name);
    }
    return fmt::format("'{}' is none of {}", text, all);
}

Wrong choose_renderer(std::string_view text, std::optional<RendererChoice>& target) {
    const std::optional<RendererChoice> choice = renderer_choice(text);
    if (!choice) {
        return fmt::format("'{}' is none of {}", text, joined(renderer_choice_names(), ", "));
    }
    target = choice;
    return std::nullopt;
}

Wrong choose_theme(std::string_view text, std::optional<ThemeChoice>& target) {
    const std::optional<ThemeChoice> choice = theme_choice(text);
    if (!choice) return fmt::format("'{}' is none of {}", text, joined(theme_choice_names(), ", "));
    target = choice;
    return std::nullopt;
}

std::optional<double> number_in(std::string_view text, double least, double most) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= least) ||
        value > most)
        return std::nullopt;
    return value;
}

Wrong set_fps(std::string_view text, std::optional<double>& fps) {
    const auto value = number_in(text, 1.0, 1000.0);
    if (!value) return fmt::format("'{}' is not a number in 1..1000", text);
    fps = value;
    return std::nullopt;
}

Wrong set_hand(std::string_view text, int& hand) {
    const auto value = number_in(text, least_hand, most_hand);
    if (!value || *value != static_cast<int>(*value))
        return fmt::format("'{}' is none of 1, 2, 3, 4", text);
    hand = static_cast<int>(*value);
    return std::nullopt;
}

Wrong set_key_repeat(std::string_view text, std::optional<KeyRepeatTimes>& target) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const auto delay = number_in(text.substr(0, blank), 100.0, 2000.0);
    const auto period = number_in(text.substr(std::min(blank + 1, text.size())), 1.0, 200.0);
    if (!delay || !period)
        return fmt::format(
            "'{}' is not a delay in 100..2000 ms and a period in 1..200 ms, as in '{}'", text,
            "660 40");
    target = {*delay / 1000.0, *period / 1000.0};
    return std::nullopt;
}

struct Setting {
    std::string_view name;
    Wrong (*set)(Preferences&, std::string_view);
};

constexpr Setting settings[] = {
    {"renderer", [](Preferences& p, std::string_view v) { return choose_renderer(v, p.renderer); }},
    {"colors",
     [](Preferences& p, std::string_view v) { return choose(color_choices, v, p.colors); }},
    {"theme", [](Preferences& p, std::string_view v) { return choose_theme(v, p.theme); }},
    {"background",
     [](Preferences& p, std::string_view v) { return choose(backgrounds, v, p.light_background); }},
    {"fps", [](Preferences& p, std::string_view v) { return set_fps(v, p.fps); }},
    {"mouse", [](Preferences& p, std::string_view v) { return choose(switches, v, p.mouse); }},
    {"color-by",
     [](Preferences& p, std::string_view v) { return choose(color_bys, v, p.color_by); }},
    {"balls",
     [](Preferences& p, std::string_view v) { return choose(ball_styles, v, p.ball_style); }},
    {"trails", [](Preferences& p, std::string_view v) { return choose(switches, v, p.trails); }},
    {"bell", [](Preferences& p, std::string_view v) { return choose(switches, v, p.bell); }},
    {"hand", [](Preferences& p, std::string_view v) { return set_hand(v, p.hand); }},
    {"key-repeat",
     [](Preferences& p, std::string_view v) { return set_key_repeat(v, p.key_repeat); }},
};

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// One parsed line; `name` is empty if the line states nothing.
struct Statement {
    std::string_view name;
    std::string_view value;
    bool has_equals = false;
};

Statement statement_of(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::size_t equals = line.find('=');
    Statement statement;
    statement.has_equals = equals != std::string_view::npos;
    statement.name = trimmed(line.substr(0, equals));
    if (statement.has_equals) statement.value = trimmed(line.substr(equals + 1));
    return statement;
}

/// Calls `visit(line)` for each line, without its line end and the text's byte order mark.
void for_each_line(std::string_view text, const std::function<void(std::string_view)>& visit) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        visit(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

/// An error, and the part of the line that it is about.
struct Mistake {
    std::string_view where;
    std::string message;
};

std::optional<Mistake> obey(Preferences& preferences, std::string_view line) {
    const Statement statement = statement_of(line);
    if (!statement.has_equals) {
        if (statement.name.empty()) return std::nullopt;
        return Mistake{statement.name, "expected 'key = action' or 'setting = value'"};
    }
    if (statement.name.empty()) return Mistake{line, "a name is missing before '='"};
    const std::string_view after = statement.value.empty() ? statement.name : statement.value;
    for (const Setting& setting : settings) {
        if (setting.name != statement.name) continue;
        if (auto wrong = setting.set(preferences, statement.value)) return Mistake{after, *wrong};
        return std::nullopt;
    }
    const auto key = key_named(statement.name);
    if (!key) {
        std::vector<std::string_view> names;
        for (const Setting& setting : settings)
            names.push_back(setting.name);
        return Mistake{statement.name,
                       fmt::format("there is no key or setting '{}'{}", statement.name,
                                   suggestion(statement.name, names))};
    }
    const Action* const action = action_named(statement.value);
    if (!action && statement.value != "none")
        return Mistake{after, fmt::format("there is no action '{}'{}", statement.value,
                                          suggestion(statement.value, action_names()))};
    preferences.keys.bind(*key, action);
    return std::nullopt;
}

}  // namespace

PreferencesText read_preferences(std::string_view text, std::string_view file) {
    PreferencesText result;
    int line_number = 0;
    for_each_line(text, [&](std::string_view line) {
        ++line_number;
        const auto mistake = obey(result.preferences, line);
        if (!mistake) return;
        const auto offset = static_cast<std::size_t>(mistake->where.data() - line.data());
        result.problems.push_back(fmt::format("{}:{}:{}: error: {}", file, line_number,
                                              columns_of(line.substr(0, offset)) + 1,
                                              mistake->message));
    });
    return result;
}

std::string with_setting(std::string_view text, std::string_view name, std::string_view value) {
    std::string result;
    bool is_set = false;
    for_each_line(text, [&](std::string_view line) {
        const Statement statement = statement_of(line);
        if (statement.has_equals && statement.name == name) {
            // Of several lines the last was in force: the first is changed, the others are removed.
            if (!is_set) {
                const auto comment = line.find('#');
                result += fmt::format("{} = {}", name, value);
                if (comment != std::string_view::npos)
                    result += "  " + std::string(line.substr(comment));
                result += '\n';
            }
            is_set = true;
        } else {
            result += line;
            result += '\n';
        }
    });
    if (!is_set) result += fmt::format("{} = {}\n", name, value);
    return result;
}

std::string_view text_of(ColorBy by) {
    return name_in(color_bys, by);
}

std::string_view text_of(BallStyle style) {
    return name_in(ball_styles, style);
}

std::string text_of(const KeyRepeatTimes& times) {
    return fmt::format("{:.0f} {:.0f}", 1000.0 * times.delay, 1000.0 * times.period);
}

std::optional<std::string> preferences_path() {
    const auto folder = configuration_folder();
    if (!folder) return std::nullopt;
    return *folder + "/preferences";
}

PreferencesText load_preferences() {
    const auto path = preferences_path();
    if (!path) return {};
    const FileText file = read_file(*path);
    if (file.text) return read_preferences(*file.text, *path);
    PreferencesText none;
    std::error_code ignored;
    if (std::filesystem::exists(*path, ignored)) none.problems.push_back(file.error);
    return none;
}

std::optional<std::string> write_preference(std::string_view name, std::string_view value) {
    const auto path = preferences_path();
    const auto folder = configuration_folder();
    if (!path || !folder) return no_folder_reason();
    if (auto fault = make_folder(*folder)) return fault;
    const FileLock lock(*path + ".lock", FileLock::Wait::a_while);
    if (!lock.is_held()) return lock.error();
    FileText text = read_file(*path);
    std::error_code ignored;
    if (!text.text && std::filesystem::exists(*path, ignored)) return text.error;
    return write_file_atomically(*path, with_setting(text.text.value_or(""), name, value),
                                 Access::owner);
}

}  // namespace carom
