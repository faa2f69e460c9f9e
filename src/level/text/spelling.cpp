#include "level/text/spelling.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

// What authors write who come from other programs, and what it is called here.
struct Synonym {
    std::string_view written;
    std::string_view meant;
};
constexpr Synonym synonyms[] = {
    // statements
    {"wall", "edge"},
    {"line", "edge"},
    {"segment", "edge"},
    {"polyline", "edge"},
    {"polygon", "edge"},
    {"circle", "peg"},
    {"post", "peg"},
    {"disc", "ball"},
    {"disk", "ball"},
    {"sphere", "ball"},
    {"rect", "box"},
    {"rectangle", "box"},
    {"for", "repeat"},
    {"loop", "repeat"},
    {"var", "let"},
    {"set", "let"},
    {"const", "let"},
    {"import", "include"},
    {"emitter", "spawn"},
    {"assert", "expect"},
    {"plot", "show"},
    {"text", "label"},
    {"rectangle", "rect"},
    {"if", "on"},
    {"when", "on"},
    {"rule", "on"},
    // events, conditions and actions of rules
    {"potted", "pocketed"},
    {"sunk", "pocketed"},
    {"sinks", "pocketed"},
    {"falls", "pocketed"},
    {"touches", "hit"},
    {"strikes", "hit"},
    {"collides", "hit"},
    {"bounces", "rail"},
    {"exits", "leave"},
    {"points", "score"},
    {"say", "message"},
    {"print", "message"},
    {"pass", "turn"},
    {"quit", "end"},
    // terms, and units
    {"friction", "spin"},
    {"torus", "wrap"},
    {"periodic", "wrap"},
    {"inch", "in"},
    {"inches", "in"},
    {"meter", "m"},
    {"metre", "m"},
    // keys
    {"velocity", "v"},
    {"vel", "v"},
    {"speed", "v"},
    {"radius", "r"},
    {"thickness", "r"},
    {"width", "r"},
    {"mass", "m"},
    {"bounce", "e"},
    {"restitution", "e"},
    {"elasticity", "e"},
    {"friction", "mu"},
    {"position", "at"},
    {"pos", "at"},
    {"center", "at"},
    {"spin", "w"},
    {"type", "kind"},
    {"angle", "turn"},
    {"rotate", "turn"},
    {"interval", "every"},
    {"colour", "color"},
};

}  // namespace

std::optional<std::string_view> meant_by(std::string_view word,
                                         const std::vector<std::string_view>& candidates) {
    for (const Synonym& synonym : synonyms)
        if (synonym.written == word && std::ranges::count(candidates, synonym.meant) > 0)
            return synonym.meant;
    return std::nullopt;
}

int edit_distance(std::string_view a, std::string_view b) {
    // The dynamic program needs only the last three rows of its table.
    std::vector<int> before(b.size() + 1);
    std::vector<int> last(b.size() + 1);
    std::vector<int> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = last[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = std::min({change, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

// ASCII letters only, as names have.
bool differ_in_case_only(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 32) : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::optional<std::string_view> nearest_word(std::string_view word,
                                             const std::vector<std::string_view>& candidates) {
    constexpr std::size_t longest = 64;  // bounds the work
    std::size_t tried = 0;
    if (word.empty() || word.size() > longest) return std::nullopt;
    if (const auto meant = meant_by(word, candidates)) return meant;
    std::optional<std::string_view> best;
    std::size_t best_distance = std::max(std::size_t{1}, word.size() / 3);
    for (const std::string_view candidate : candidates) {
        if (++tried > max_candidates) break;
        if (differ_in_case_only(word, candidate)) return candidate;
        if (candidate.size() < 2 || candidate.size() > word.size() + best_distance ||
            candidate.size() + best_distance < word.size()) {
            continue;
        }
        const auto distance = static_cast<std::size_t>(edit_distance(word, candidate));
        if (distance > best_distance || (best && distance == best_distance)) continue;
        best = candidate;
        best_distance = distance;
    }
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates,
                         std::string otherwise) {
    const std::optional<std::string_view> best = nearest_word(word, candidates);
    return best ? fmt::format("did you mean '{}'?", *best) : otherwise;
}

}  // namespace carom
