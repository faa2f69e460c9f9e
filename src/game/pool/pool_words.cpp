#include "game/pool/pool_words.h"

#include <fmt/format.h>

#include <cmath>

#include "game/referees/referee.h"

namespace carom {
namespace {

const std::string& name_of(const PlayerNames& names, int player) {
    return names[static_cast<std::size_t>(player)];
}

// "player 1 breaks", "you break". `verb`: in the third person, on s.
std::string does(const std::string& name, std::string_view verb) {
    if (name == "you") verb.remove_suffix(1);
    return fmt::format("{} {}", name, verb);
}

// "you win the frame", or the match if that was its last frame.
std::string win_text(const PoolPlay& play, const PlayerNames& names) {
    if (const auto winner = match_winner(play))
        return fmt::format("{} the match {}:{}", does(name_of(names, *winner), "wins"),
                           play.frames[static_cast<std::size_t>(*winner)],
                           play.frames[static_cast<std::size_t>(1 - *winner)]);
    return does(name_of(names, *play.rules.winner), "wins") + " the frame";
}

// The player's target: ", solids, 5 left", ", on the 8", ", 3 to go in the top right".
std::string target_text(const Scene& scene, const PoolState& rules) {
    if (rules.phase == PoolPhase::breaking) return "";
    const auto pocket = rules.referee->pocket_of(rules, rules.player);
    return ", " + rules.referee->target_text(rules) +
           (pocket ? " in the " + pocket_name(scene, *pocket) : "");
}

std::string task_text(const PoolPlay& play) {
    const PoolState& rules = play.rules;
    if (play.is_shooting) return "the balls roll";
    if (rules.phase == PoolPhase::choosing) return "to choose";
    if (rules.in_hand == CueInHand::anywhere) return "ball in hand";
    if (rules.in_hand == CueInHand::behind_head_string)
        return "ball in hand behind the head string";
    if (rules.in_hand == CueInHand::in_d) return "ball in hand in the D";
    if (rules.may_push_out) return "to shoot, or push out";
    return "to shoot";
}

std::string fallen_text(const PoolPlay& play) {
    const Referee& referee = *play.rules.referee;
    const PoolShot& shot = play.shot;
    std::string balls;
    int count = 0;
    for (const PoolShot::Pocketed& pocketed : shot.pocketed) {
        if (pocketed.ball == cue_ball) continue;
        balls += count > 0 ? ", " : "";
        balls += referee.has_numbers() ? fmt::format("{}", pocketed.ball)
                                       : referee.ball_name(pocketed.ball);
        ++count;
    }
    return count == 0 ? "" : fmt::format("pocketed: {}. ", balls);
}

}  // namespace

std::string pocket_name(const Scene& scene, int pocket) {
    const auto place_of = [&](std::size_t i) {
        return scene.world.zones()[scene.pool.pockets[i]].shape.start;
    };
    const Vec2 middle = center(scene.view);
    const Vec2 place = place_of(static_cast<std::size_t>(pocket)) - middle;
    const Vec2 half = size(scene.view) * 0.5;
    const auto side = [](double share, const char* less, const char* more) {
        return share < -0.3 ? less : share > 0.3 ? more : "middle";
    };
    return fmt::format("{} {}", side(place.y / half.y, "bottom", "top"),
                       side(place.x / half.x, "left", "right"));
}

std::string_view foul_text(PoolFoul foul) {
    switch (foul) {
        case PoolFoul::none:
            return "";
        case PoolFoul::scratch:
            return "the cue ball fell";
        case PoolFoul::no_hit:
            return "no ball was hit";
        case PoolFoul::wrong_ball:
            return "the wrong ball was hit first";
        case PoolFoul::no_rail:
            return "no ball fell or hit a cushion";
        case PoolFoul::weak_break:
            return "fewer than four balls hit a cushion";
        case PoolFoul::time:
            return "the time is up";
        case PoolFoul::behind_string:
            return "the ball hit first was behind the head string";
        case PoolFoul::weak_opening:
            return "the cue ball and two balls must hit a cushion";
        case PoolFoul::wrong_pot:
            return "a ball fell that was not on";
        case PoolFoul::hidden:
            return "snookered behind the free ball";
    }
    return "";
}

std::string_view choice_text(const PoolState& rules, PoolChoice choice) {
    switch (choice) {
        case PoolChoice::take_table:
            return rules.in_hand == CueInHand::no ? "shoot from here" : "take ball in hand";
        case PoolChoice::break_again:
            return "rack again and break";
        case PoolChoice::let_break:
            return "rack, the other breaks";
        case PoolChoice::spot_eight:
            return "spot the 8 and continue";
        case PoolChoice::return_push:
            return "the other must shoot";
        case PoolChoice::replace:
            return "put the balls back";
    }
    return "";
}

std::string call_text(const Scene& scene, const PoolCall& call) {
    switch (call.kind) {
        case PoolCall::Kind::pot: {
            const Referee& referee = *referee_of(scene.game);
            const std::string ball = referee.ball_name(call.ball);
            if (!referee.calls_pocket()) return ball;
            return fmt::format("{} into the {}", ball, pocket_name(scene, call.pocket));
        }
        case PoolCall::Kind::safety:
            return "safety";
        case PoolCall::Kind::push_out:
            return "push-out";
        default:
            return "";
    }
}

std::string turn_text(const Scene& scene, const PoolPlay& play, const PlayerNames& names) {
    const PoolState& rules = play.rules;
    const std::string points = rules.referee->score_text(rules);
    // The frames, once there are any.
    std::string frames;
    if (play.race > 0 || play.frames != std::array<std::uint32_t, 2>{})
        frames = fmt::format("{}:{}{} ", play.frames[0], play.frames[1],
                             play.race > 0 ? fmt::format(" (race to {}),", play.race) : "");
    const std::string score = points.empty() ? "" : fmt::format(" ({})", points);
    if (rules.winner) return frames + win_text(play, names) + score;
    const std::string warning = is_warned(rules) && !play.is_shooting
                                    ? ", " + std::string(rules.referee->warning_text())
                                    : "";
    const std::string name = name_of(names, rules.player);
    if (rules.phase == PoolPhase::breaking && !play.is_shooting)
        return frames + does(name, "breaks") + score + ": " + task_text(play) + warning;
    return frames + name + score + target_text(scene, rules) + ": " + task_text(play) + warning;
}

std::string clock_text(double seconds) {
    return fmt::format("{:.0f} s", std::ceil(seconds));
}

namespace {

// As sentences: each with a capital, and a full stop at the end.
std::string in_sentences(std::string text) {
    bool begins = true;
    for (char& c : text) {
        if (begins && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        if (c != ' ') begins = c == '.';
    }
    return text.empty() || text.ends_with('.') ? text : text + ".";
}

// Whether so many shots without a pot led to the new rack. After a weak break a player chose it.
bool is_stalemate(const PoolPlay& play) {
    return play.rules.options.stalemate > 0 && play.last_foul == PoolFoul::none;
}

// "Foul, 4: no ball was hit. ", "Foul and a miss, 4: no ball was hit. "
std::string foul_sentence(PoolFoul foul, int penalty, bool is_miss) {
    if (foul == PoolFoul::none) return "";
    return fmt::format("Foul{}{}: {}. ", is_miss ? " and a miss" : "",
                       penalty == 0 ? "" : fmt::format(", {}", penalty), foul_text(foul));
}

// What a foul or the reason for the ruling adds: "Foul: no ball was hit. 3 fouls in a row. ".
std::string why_text(const PoolPlay& play, const PlayerNames& names) {
    const PoolState& rules = play.rules;
    const auto shooter = static_cast<std::size_t>(*play.shooter);
    const std::string_view reason =
        rules.referee->reason_text(rules, play.called, play.shot, *play.shooter);
    const bool is_new_rack = rules.phase == PoolPhase::breaking;
    if (play.last_foul == PoolFoul::none)
        return reason.empty() || is_new_rack ? "" : fmt::format("{}. ", reason);
    std::string text = foul_sentence(play.last_foul, play.last_penalty, is_miss(rules));
    const int most = rules.options.fouls_that_lose;
    if (rules.winner && most > 0 && rules.fouls[shooter] >= most)
        text += fmt::format("{} fouls in a row. ", most);
    if ((rules.phase == PoolPhase::choosing || is_new_rack) && !reason.empty())
        text += fmt::format("{}. ", reason);
    PoolState warned = rules;
    warned.player = *play.shooter;
    if (is_warned(warned))
        text +=
            fmt::format("{}: {}. ", name_of(names, warned.player), rules.referee->warning_text());
    return text;
}

// What a player decided, after the foul that led to it: "Foul, 4: no ball was hit. You shoot from
// here".
std::string decision_text(const PoolPlay& play, const PlayerNames& names) {
    const PoolPlay::Decision& decision = *play.decision;
    const std::string& next = name_of(names, play.rules.player);
    if (!decision.choice)
        return fmt::format("{}. {}", does(next, "concedes"), win_text(play, names));
    const std::string foul = foul_sentence(decision.foul, decision.penalty, decision.was_miss);
    switch (*decision.choice) {
        case PoolChoice::take_table:
            return play.rules.in_hand == CueInHand::no
                       ? fmt::format("{}{} from here", foul, does(next, "shoots"))
                       : fmt::format("{}{}: ball in hand", foul, next);
        case PoolChoice::return_push:
            return fmt::format("{}{} again", foul, does(next, "shoots"));
        case PoolChoice::replace:
            return fmt::format("{}the balls are put back. {} again", foul, does(next, "shoots"));
        case PoolChoice::spot_eight:
            return "the 8 is spotted. " + does(next, "continues");
        case PoolChoice::break_again:
        case PoolChoice::let_break:
            return foul + does(next, "breaks") +
                   (play.rules.player == play.shooter ? " again" : "");
    }
    return "";
}

std::string outcome_parts(const PoolPlay& play, const PlayerNames& names) {
    const PoolState& rules = play.rules;
    if (play.decision) return decision_text(play, names);
    const std::string fallen = fallen_text(play);
    const std::string foul = why_text(play, names);
    if (rules.phase == PoolPhase::breaking)
        return foul + fmt::format("{}{} again", is_stalemate(play) ? "Stalemate: " : "",
                                  does(name_of(names, rules.player), "breaks"));
    if (rules.winner) return fallen + foul + win_text(play, names);
    const std::string& next = name_of(names, rules.player);
    if (rules.phase == PoolPhase::choosing) return fallen + foul + does(next, "chooses");
    if (rules.in_hand != CueInHand::no) return fallen + foul + next + ": ball in hand";
    if (rules.player == *play.shooter) return fallen + does(next, "continues");
    const std::string missed = fallen.empty() && foul.empty() ? "no ball fell. " : "";
    return missed + fallen + foul + does(next, "shoots");
}

}  // namespace

std::string outcome_text(const PoolPlay& play, const PlayerNames& names) {
    if (!play.shooter || play.is_shooting) return "";
    return in_sentences(outcome_parts(play, names));
}

}  // namespace carom
