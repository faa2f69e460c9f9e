#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Characters beyond ASCII that editors and web pages put in place of an ASCII one: a long minus, a
/// blank that does not break, a curly quote. In a level they are mistakes, but clear ones.
namespace carom {

struct Lookalike {
    char32_t character = 0;
    char meant = ' ';
    std::string_view name;    ///< "a no-break space"
    std::string_view remedy;  ///< "write an ordinary blank"
};

/// Null: the character is none.
const Lookalike* lookalike(char32_t character);

/// Whether the character shows nothing, or changes the order of others: it could make a message say
/// something else than the level does. Joiners of letters and emoji do not count.
bool is_invisible(char32_t character);

/// A line with its lookalikes replaced by what they stand for, so that it has as many characters as
/// before. Text in quotes and comments keeps them.
struct MendedLine {
    struct Mend {
        const Lookalike* lookalike = nullptr;
        int column = 1;  ///< in characters, from 1
    };
    std::string text;
    std::vector<Mend> mends;  ///< empty: nothing was replaced, and `text` is empty
};
MendedLine mended(std::string_view line);

}  // namespace carom
