#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "level/values/dimension.h"

/// Every statement, with its keys: the one table that parsing, messages and the manual share.
namespace carom {

/// The shape of what stands behind a key.
enum class KeyShape {
    scalar,    ///< a number
    pair,      ///< x,y
    box,       ///< x0,y0,x1,y1
    range,     ///< a..b, or one number
    word,      ///< a name
    deferred,  ///< a number or range that the statement evaluates itself
    call       ///< a name, or name(arguments)
};

/// What a number must be.
enum class Bound {
    any,
    not_negative,
    positive,
    share,           ///< 0 to 1
    positive_share,  ///< more than 0, and 1 at most
    up_to_thousand,  ///< 1 to 1000
    layer            ///< 0 to 3
};

struct KeyRule {
    std::string_view name;
    KeyShape form = KeyShape::scalar;
    Measure measure = Measure::number;
    Bound bound = Bound::any;
    bool is_required = false;
    bool repeats = false;  ///< at=: as often as one likes, a place each
};

enum class Place {
    top,      ///< outside of blocks only
    anywhere  ///< also in mirror, repeat and part
};

/// A statement, or one of several that share a keyword ("use gravity").
struct Statement {
    std::string_view name;
    std::string_view usage;  ///< its line in the grammar
    Place place = Place::anywhere;
    bool opens_block = false;
    int plain_least = 0;  ///< words that are neither points, keys nor flags
    int plain_most = 0;
    int points_least = 0;
    int points_most = 0;
    Measure point_measure = Measure::length;
    std::vector<KeyRule> keys;
    std::vector<std::string_view> flags;
    bool takes_any_key = false;  ///< let, part and place: the author invents the keys
};

/// No limit on the number of points.
inline constexpr int many = 1'000'000'000;

std::span<const Statement> statements();
/// By full name: "edge", "use gravity". Null when there is none.
const Statement* statement_named(std::string_view name);
/// First words: "edge", "use", ... each once.
std::vector<std::string_view> keywords();
/// Second words of the statements that begin with `keyword`: "gravity", "drag", ...
std::vector<std::string_view> second_words(std::string_view keyword);
/// All usages, one a line, in the order of the manual.
std::string grammar();

}  // namespace carom
