#pragma once

#include <vterm.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// A terminal in memory (libvterm): shows what a person would see.
namespace carom::test {

/// The terminal's answers to queries, beyond those of libvterm.
struct EmulatorOptions {
    bool answers = true;            ///< to any query
    bool has_key_protocol = false;  ///< the kitty protocol
    bool has_pixel_mouse = false;
    bool has_synchronized_output = false;
    std::string background;  ///< such as "rgb:ffff/ffff/ffff"; empty: no answer
    int cell_wide = 0;       ///< pixels; 0: no answer
    int cell_high = 0;
};

/// The visible look of a cell as text, equal for cells that look alike: a blank has no foreground,
/// a full block is a blank of the other colour, and so on. Colours: -1 for the terminal's own.
struct CellLook {
    char32_t glyph = U' ';
    int foreground = -1;
    int background = -1;
    bool is_bold = false;
    bool is_underlined = false;
    bool is_reversed = false;
};
std::string described(const CellLook& look);

class Emulator {
  public:
    /// `reply` receives the terminal's answers.
    Emulator(int columns, int rows, const EmulatorOptions& options,
             std::function<void(std::string_view)> reply);

    void write(std::string_view bytes);
    void resize(int columns, int rows);

    int columns() const;
    int rows() const;
    /// UTF-8, rows ended by newlines, trailing blanks cut.
    std::string text() const;
    std::string row(int row) const;
    VTermScreenCell cell(int column, int row) const;
    CellLook look(int column, int row) const;
    /// The palette index, or 0x1RRGGBB for a 24-bit colour; none: the terminal's own.
    std::optional<int> foreground(int column, int row) const;
    std::optional<int> background(int column, int row) const;

    /// Whether a DEC private mode is set, such as 1049, 25 or 1002 (25, the cursor, is set at the
    /// start).
    bool mode(int number) const;
    /// Entries on the stack of the kitty keyboard protocol.
    int key_stack() const { return key_stack_; }
    unsigned bells() const { return bells_; }

  private:
    void follow(std::string_view bytes);
    void follow_sequence(std::string_view sequence);
    void send(std::string_view bytes);

    struct Free {
        void operator()(VTerm* terminal) const { vterm_free(terminal); }
    };
    std::unique_ptr<VTerm, Free> terminal_;
    VTermScreen* screen_ = nullptr;
    VTermScreenCallbacks callbacks_{};
    EmulatorOptions options_;
    std::function<void(std::string_view)> reply_;
    std::map<int, bool> modes_{{25, true}};
    std::string begun_;  // an incomplete control sequence
    int key_stack_ = 0;
    unsigned bells_ = 0;
};

}  // namespace carom::test
