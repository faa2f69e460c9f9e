#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "level/ir/arguments.h"
#include "level/scene/games.h"
#include "level/statements/families.h"
#include "level/statements/rules.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

void set_pinball(const Arguments& arguments, PinballTable& table) {
    table.is_game = true;
    if (arguments.has("balls")) table.balls = arguments.count("balls");
    table.save = arguments.number_or("save", table.save);
    if (arguments.has("tilt")) table.warnings = arguments.count("tilt");
    if (arguments.has("bonus")) table.bonus = arguments.count("bonus");
    if (arguments.has("replay")) table.replay = arguments.count("replay");
    if (arguments.has("highscores")) table.highscores = arguments.count("highscores");
}

constexpr std::array<std::string_view, 5> pool_keys{"race", "clock", "stalemate", "breaks",
                                                    "first"};

// The games of pool that have this key, if only some have it: "nineball or tenball".
std::string owners_of(std::string_view key) {
    std::string owners;
    for (const GameRow& row : game_rows())
        if (std::ranges::count(row.keys, key) > 0)
            owners += (owners.empty() ? "game " : " or ") + std::string(row.name);
    return owners;
}

// Whether the word of the key is `special`, and not `usual`, its value where the key is absent.
bool is_special(const Arguments& arguments, std::string_view key, std::string_view special,
                std::string_view usual, Context& context) {
    const std::optional<Word> word = arguments.word(key);
    if (!word || word->text == usual) return false;
    if (word->text == special) return true;
    context.reporter.error("unknown-rule", word->span(),
                           fmt::format("{}= is not '{}'", key, word->text),
                           fmt::format("write {}={} or {}={}", key, usual, key, special));
    return false;
}

void set_pool_rules(const Arguments& arguments, Context& context) {
    PoolRules& rules = context.ir.settings.rules;
    rules.nine_on_break_wins = !is_special(arguments, "nine", "spotted", "wins", context);
    rules.winner_breaks = is_special(arguments, "breaks", "winner", "turns", context);
    rules.is_tossed = is_special(arguments, "first", "toss", "player1", context);
    if (arguments.has("fouls")) rules.fouls_that_lose = static_cast<int>(arguments.count("fouls"));
    if (arguments.has("points")) rules.points = static_cast<int>(arguments.count("points"));
    if (arguments.has("stalemate"))
        rules.stalemate = static_cast<int>(arguments.count("stalemate"));
}

void set_players(const Arguments& arguments, bool is_shots, Context& context) {
    constexpr std::uint32_t most_players = 4;
    LevelSettings& settings = context.ir.settings;
    if (arguments.has("players")) settings.players = arguments.count("players");
    if (settings.players > most_players) {
        context.reporter.error("too-many-players", arguments.span_of("players"),
                               fmt::format("{} players are too many", settings.players),
                               "write players=1 to players=4");
        settings.players = most_players;
    }
    settings.is_shots = is_shots;
    settings.least_wins = is_special(arguments, "wins", "least", "most", context);
    settings.settle = arguments.number_or("settle", 0.0);
    settings.may_miss = is_special(arguments, "stroke", "hand", "exact", context);
}

void set_game(const Arguments& arguments, const Frame&, Context& context) {
    using enum GameRow::Family;
    const Word& word = arguments.plain.front();
    context.ir.settings.game_at = word.span();
    const GameRow* game = game_named(word.text);
    const GameRow::Family family = game ? game->family : none;
    if (family == none && !arguments.values.empty()) {
        context.reporter.error("game-without-keys", word.span(),
                               fmt::format("game {} has no keys", word.text),
                               "balls=, save=, tilt= and the like belong to game pinball, race= "
                               "and clock= to games of pool");
        return;
    }
    for (const auto& [key, value] : arguments.values) {
        const bool is_of_pool = std::ranges::count(pool_keys, key) > 0;
        const std::string owners = owners_of(key);
        if (game && std::ranges::count(game->keys, key) > 0) continue;
        if (family == pinball && key == "players") continue;
        if (owners.empty() && family != shots && is_of_pool == (family == pool)) continue;
        context.reporter.error("game-key-of-other-game", arguments.span_of(key),
                               fmt::format("game {} has no {}=", word.text, key),
                               !owners.empty() ? fmt::format("{}= belongs to {}", key, owners)
                               : family == shots
                                   ? "game shots has players=, wins=, stroke= and settle="
                               : family == pool ? "a game of pool has race=, clock=, stalemate=, "
                                                  "breaks= and first="
                                                : "race=, clock=, stalemate=, breaks= and first= "
                                                  "belong to games of pool");
        return;
    }
    if (!game) {
        std::vector<std::string_view> known;
        for (const GameRow& row : game_rows())
            known.push_back(row.name);
        context.reporter.error(
            "unknown-game", word.span(), fmt::format("there is no game '{}'", word.text),
            did_you_mean(word.text, known, fmt::format("there are: {}", game_names(" "))));
        return;
    }
    context.ir.settings.game = std::string(word.text);
    if (family == pinball) set_pinball(arguments, context.ir.settings.table);
    if (arguments.has("race")) context.ir.settings.race = arguments.count("race");
    context.ir.settings.clock = arguments.number_or("clock", 0.0);
    set_pool_rules(arguments, context);
    set_players(arguments, family == shots, context);
}

}  // namespace

std::vector<Statement> game_statements() {
    using enum KeyShape;
    using enum Bound;
    static const std::string game_usage =
        "game " + game_names("|") +
        " [race=N] [clock=TIME] [stalemate=N] [breaks=turns|winner] [first=player1|toss] "
        "[fouls=N] [nine=wins|spotted] [points=N] [balls=N] [save=TIME] [tilt=N] [bonus=N] "
        "[replay=N] "
        "[highscores=N] [players=N] [wins=most|least] [stroke=exact|hand] [settle=TIME]";
    return {
        {.name = "game",
         .usage = game_usage,
         .action = set_game,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {{"race", scalar, Measure::whole, up_to_thousand},
                  {"clock", scalar, Measure::time, positive},
                  {"stalemate", scalar, Measure::whole, up_to_thousand},
                  {"breaks", KeyShape::word},
                  {"first", KeyShape::word},
                  {"fouls", scalar, Measure::whole, not_negative},
                  {"nine", KeyShape::word},
                  {"points", scalar, Measure::whole, up_to_thousand},
                  {"balls", scalar, Measure::whole, up_to_thousand},
                  {"save", scalar, Measure::time, not_negative},
                  {"tilt", scalar, Measure::whole, not_negative},
                  {"bonus", scalar, Measure::whole, not_negative},
                  {"replay", scalar, Measure::whole, not_negative},
                  {"highscores", scalar, Measure::whole, not_negative},
                  {"players", scalar, Measure::whole, positive},
                  {"wins", KeyShape::word},
                  {"stroke", KeyShape::word},
                  {"settle", scalar, Measure::time, not_negative}},
         .is_unique = true,
         .settable = Settable::whole},
        {.name = "var",
         .usage = "var NAME [of game|player|turn|shot] [start=N]",
         .action = add_variable,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 3,
         .keys = {{"start", scalar, Measure::whole, any}},
         .settable = Settable::by_name},
        {.name = "timer",
         .usage = "timer NAME TIME",
         .action = add_timer,
         .place = Place::top,
         .plain_least = 2,
         .plain_most = 2,
         .settable = Settable::by_name},
        {.name = "on",
         .usage = "on NAME EVENT [NAME] [once] [if|while|unless CONDITION [and CONDITION ...] ...] "
                  "ACTION [VALUE ...], ...",
         .action = add_rule,
         .place = Place::top,
         .plain_least = 3,
         .plain_most = many,
         .is_sentence = true},
        {.name = "task",
         .usage = "task \"TEXT\" [for NAME ...] [if|unless CONDITION [and CONDITION ...] ...]",
         .action = add_task,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = many,
         .is_sentence = true},
        {.name = "goal",
         .usage = "goal \"TEXT\" [within N [N [N]] shots|seconds|of VALUE | with N [N [N]] of "
                  "VALUE] if|unless "
                  "CONDITION [and CONDITION ...] ...",
         .action = add_goal,
         .place = Place::top,
         .plain_least = 3,
         .plain_most = many,
         .is_sentence = true,
         .is_unique = true},
    };
}

}  // namespace carom
