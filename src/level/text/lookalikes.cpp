#include "level/text/lookalikes.h"

#include <algorithm>
#include <array>

#include "level/text/utf8.h"

namespace carom {
namespace {

constexpr std::string_view write_minus = "write an ordinary minus: -";
constexpr std::string_view write_blank = "write an ordinary blank";
constexpr std::string_view write_quote = "write a straight quote: \"";
constexpr std::string_view take_out = "take it out, or write an ordinary blank";

constexpr std::array lookalikes{
    Lookalike{0x00a0, ' ', "a no-break space", write_blank},
    Lookalike{0x00ab, '"', "a typographic quote", write_quote},
    Lookalike{0x00ad, ' ', "an invisible hyphen", take_out},
    Lookalike{0x00bb, '"', "a typographic quote", write_quote},
    Lookalike{0x00d7, '*', "a multiplication sign", "write a product with *"},
    Lookalike{0x00f7, '/', "a division sign", "write a quotient with /"},
    Lookalike{0x2010, '-', "a typographic hyphen", write_minus},
    Lookalike{0x2011, '-', "a no-break hyphen", write_minus},
    Lookalike{0x2012, '-', "a figure dash", write_minus},
    Lookalike{0x2013, '-', "an en dash", write_minus},
    Lookalike{0x2014, '-', "an em dash", write_minus},
    Lookalike{0x201c, '"', "a typographic quote", write_quote},
    Lookalike{0x201d, '"', "a typographic quote", write_quote},
    Lookalike{0x201e, '"', "a typographic quote", write_quote},
    Lookalike{0x201f, '"', "a typographic quote", write_quote},
    Lookalike{0x2028, ' ', "a line separator", write_blank},
    Lookalike{0x2029, ' ', "a paragraph separator", write_blank},
    Lookalike{0x202f, ' ', "a narrow no-break space", write_blank},
    Lookalike{0x205f, ' ', "a mathematical space", write_blank},
    Lookalike{0x2212, '-', "a typographic minus", write_minus},
    Lookalike{0x22c5, '*', "a raised dot", "write a product with *"},
    Lookalike{0x3000, ' ', "a wide blank", write_blank},
    Lookalike{0xfeff, ' ', "a byte order mark", take_out},
};

// Ranges of blanks, and of characters that show nothing but change the order of others.
constexpr Lookalike some_blank{0x2000, ' ', "a typographic blank", write_blank};
constexpr Lookalike invisible{0x200b, ' ', "an invisible character", take_out};

}  // namespace

const Lookalike* lookalike(char32_t character) {
    const auto is_in = [&](char32_t first, char32_t last) {
        return character >= first && character <= last;
    };
    if (is_in(0x2000, 0x200a)) return &some_blank;
    if (is_in(0x200b, 0x200f) || is_in(0x202a, 0x202e) || is_in(0x2060, 0x2069)) return &invisible;
    const auto found = std::ranges::find(lookalikes, character, &Lookalike::character);
    return found == lookalikes.end() ? nullptr : &*found;
}

bool is_invisible(char32_t character) {
    constexpr char32_t joiner = 0x200d;
    constexpr char32_t non_joiner = 0x200c;
    return lookalike(character) == &invisible && character != joiner && character != non_joiner;
}

MendedLine mended(std::string_view line) {
    MendedLine result;
    if (std::ranges::all_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x80; }))
        return result;
    enum class Quotes { none, straight, typographic } quotes = Quotes::none;
    int column = 1;
    for (std::size_t i = 0; i < line.size(); ++column) {
        const auto [character, bytes] = decode_utf8(line.substr(i));
        const Lookalike* like = lookalike(character);
        const bool closes = like && like->meant == '"' && quotes == Quotes::typographic;
        if (line[i] == '#' && quotes == Quotes::none) break;
        if (line[i] == '"') quotes = quotes == Quotes::none ? Quotes::straight : Quotes::none;
        if (like && (quotes == Quotes::none || closes)) {
            result.text += like->meant;
            result.mends.push_back({like, column});
            if (like->meant == '"') quotes = closes ? Quotes::none : Quotes::typographic;
        } else {
            result.text += line.substr(i, bytes);
        }
        i += bytes;
    }
    if (result.mends.empty()) result.text.clear();
    return result;
}

}  // namespace carom
