#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/action.h"
#include "carom/context/help_page.h"
#include "carom/context/key.h"
#include "terminal/panels/pages.h"

/// Maps keys to actions. In each layer (KeyLayer) a key has at most one action; an action may have
/// several keys.
namespace carom {

class KeyMap {
  public:
    KeyMap();  ///< starts with the default keys

    /// Binds a key to an action; null: the key does nothing, in no layer.
    void bind(const Key& key, const Action* action);
    /// The action of a key in a layer; null: none.
    const Action* action_of(const Key& key, KeyLayer layer = KeyLayer::common) const;
    /// The button of a pinball table that the key presses; none: no button has this key.
    std::optional<Button> button_of(const Key& key) const;
    /// The keys of an action, in the order in which they were bound.
    std::vector<Key> keys_of(const Action& action) const;
    /// The action's key for hints: the first that is not by default, else the first; empty if it
    /// has none. Pre: there is such an action.
    std::string hint(std::string_view action_name) const;

    /// The help page of a way of playing, with the keys as they are bound. `words` replace those of
    /// the table of lines.
    std::vector<HelpSection> help(PlayKind kind, std::span<const HelpWords> words = {}) const;

  private:
    struct Binding {
        Key key;
        const Action* action;
        bool is_default = false;
    };
    void add(const Key& key, const Action* action, bool is_default);
    std::string keys_of(const HelpLine& line) const;

    std::vector<Binding> bindings_;
};

}  // namespace carom
