#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "carom/options/play_options.h"
#include "carom/play/key_prompt.h"
#include "carom/play/preferences.h"

/// What a player chooses while playing becomes a preference, in the player's file too.
namespace carom {

class SettingsFile {
  public:
    /// Writes `name = value` into the player's file (write_preference).
    void keep(std::string_view name, std::string_view value);
    /// Why choices are not kept, for the player. Told once.
    std::optional<std::string> take_fault();

  private:
    std::optional<std::string> fault_;
    bool has_told_ = false;
};

/// The theme after this one that looks different: `auto` is dark or light already, as the
/// terminal's background is.
std::string_view theme_after(const ThemeChoice& now, bool is_terminal_light);

/// Gives the key to the action, and the key that the action had to what the new one did. Returns
/// what they do now, for the player.
std::string change_key(const KeyPrompt::Changed& changed, KeyMap& keys, SettingsFile& file);

/// How the terminal repeats a held key, once it differs from what was known.
void keep_key_repeat(const std::optional<KeyRepeatTimes>& learnt, Preferences& preferences,
                     SettingsFile& file);

}  // namespace carom
