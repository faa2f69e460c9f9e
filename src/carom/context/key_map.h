#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/context/action.h"
#include "carom/context/key.h"
#include "terminal/panels/pages.h"

/// Which key does what. Of each layer (KeyLayer), a key does one thing at most; an action may have
/// several keys.
namespace carom {

class KeyMap {
  public:
    KeyMap();  ///< the default keys

    /// Null: the key does nothing, in no layer.
    void bind(const Key& key, const Action* action);
    /// Null: the key does nothing in this layer.
    const Action* action_of(const Key& key, KeyLayer layer = KeyLayer::common) const;
    /// The button of a pinball table that the key holds; none: it is no key of a button.
    std::optional<Button> button_of(const Key& key) const;
    /// In the order in which they were bound.
    std::vector<Key> keys_of(const Action& action) const;
    /// The action's first key, for hints; empty when it has none. Pre: there is such an action.
    std::string hint(std::string_view action_name) const;

    /// All actions with their keys, and the mouse, for the help page.
    std::vector<HelpSection> help() const;

  private:
    struct Binding {
        Key key;
        const Action* action;
    };
    KeyHelp line_of(const Action& action) const;
    bool has_default_keys(const ActionGroup& group) const;

    std::vector<Binding> bindings_;
};

}  // namespace carom
