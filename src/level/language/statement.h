#pragma once

#include <string_view>
#include <vector>

#include "level/values/dimension.h"

/// A row of the statement table: a statement's name, its arguments, and the function that executes
/// it. The parser, the messages, the manual and the interpreter all use it.
namespace carom {

struct Arguments;
struct Context;
struct Frame;

/// The shape of the value of a key.
enum class KeyShape {
    scalar,    ///< a number
    pair,      ///< x,y
    box,       ///< x0,y0,x1,y1
    range,     ///< a..b, or one number
    word,      ///< a name
    color,     ///< a name of a colour, or #rrggbb
    deferred,  ///< a number or a range, which the statement's own function evaluates
    call       ///< a name, or name(arguments)
};

/// The values that a number may have.
enum class Bound {
    any,
    not_negative,
    positive,
    unit_interval,           ///< 0 to 1
    positive_unit_interval,  ///< more than 0, and 1 at most
    up_to_thousand,          ///< 1 to 1000
    layer                    ///< 0 to 3
};

/// One key=value that a statement takes.
struct KeyRule {
    std::string_view name;
    KeyShape shape = KeyShape::scalar;
    Measure measure = Measure::number;
    Bound bound = Bound::any;
    bool is_required = false;
    bool repeats = false;     ///< may be given any number of times, one position each: at=
    bool needs_spin = false;  ///< a value other than 0 is an error without `use spin`
};

enum class Place {
    top,      ///< outside of blocks only
    anywhere  ///< also in mirror, repeat and part
};

/// How a statement of --set replaces one of the file.
enum class Settable {
    no,      ///< --set refuses it
    whole,   ///< it replaces the file's statement of the same name
    by_name  ///< it replaces the file's statement of the same name and first plain word
};

/// Executes one statement: changes the context's intermediate representation, and reports errors.
/// Everything that it places passes through the frame's transform.
using StatementAction = void (*)(const Arguments&, const Frame&, Context&);

/// A statement, or one of several that share a keyword ("use gravity").
struct Statement {
    std::string_view name;
    std::string_view usage;  ///< its line in the grammar
    /// Null: handled by the header (statements/header.h) or the block parser.
    StatementAction action = nullptr;
    Place place = Place::anywhere;
    bool opens_block = false;
    bool body_is_drawing = false;  ///< the lines up to `end` are taken verbatim: a map
    int plain_least = 0;           ///< plain words: neither points, keys nor flags
    int plain_most = 0;
    int points_least = 0;
    int points_most = 0;
    Measure point_measure = Measure::length;
    std::vector<KeyRule> keys{};
    std::vector<std::string_view> flags{};
    bool takes_any_key = false;     ///< let, part and place: the author chooses the keys
    bool takes_lone_signs = false;  ///< a sign may be a word of its own, such as a lone comma
    bool is_sentence = false;       ///< every word is a plain word, also "a=b" and "x,y"
    bool is_unique = false;         ///< a second one is an error
    Settable settable = Settable::no;
    /// The action runs even if the arguments have errors, so that its declarations exist and their
    /// uses are not reported too.
    bool runs_with_errors = false;
    /// Its plain words may name balls, edges or bins. If the statement has an error, those names
    /// are error values (LevelIr::error_names).
    bool binds_names = false;
};

/// No limit on the number of points.
inline constexpr int many = 1'000'000'000;

}  // namespace carom
