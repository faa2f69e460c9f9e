#include "carom/context/key_map.h"

#include <algorithm>

namespace carom {
namespace {

/// The default keys of a row of the table.
std::vector<Key> default_keys(const Action& action) {
    std::vector<Key> keys;
    std::string_view text = action.keys;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        keys.push_back(*key_named(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return keys;
}

/// The actions that share a line of the help page.
std::vector<const Action*> actions_of(const HelpLine& line) {
    std::vector<const Action*> shared;
    std::string_view names = line.actions;
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(' '), names.size());
        shared.push_back(&action(names.substr(0, end)));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return shared;
}

}  // namespace

KeyMap::KeyMap() {
    for (const Action& action : actions())
        for (const Key& key : default_keys(action))
            add(key, &action, true);
}

void KeyMap::bind(const Key& key, const Action* action) {
    add(key, action, false);
}

void KeyMap::add(const Key& key, const Action* action, bool is_default) {
    std::erase_if(bindings_, [&](const Binding& binding) {
        return binding.key == key && (!action || layer_of(*binding.action) == layer_of(*action));
    });
    if (action) bindings_.push_back({key, action, is_default});
}

const Action* KeyMap::action_of(const Key& key, KeyLayer layer) const {
    const auto found = std::ranges::find_if(bindings_, [&](const Binding& binding) {
        return binding.key == key && layer_of(*binding.action) == layer;
    });
    return found == bindings_.end() ? nullptr : found->action;
}

std::optional<Button> KeyMap::button_of(const Key& key) const {
    const Action* const action = action_of(key, KeyLayer::pinball);
    const Button* const button = action ? std::get_if<Button>(&action->perform) : nullptr;
    return button ? std::optional(*button) : std::nullopt;
}

std::vector<Key> KeyMap::keys_of(const Action& action) const {
    std::vector<Key> keys;
    for (const Binding& binding : bindings_)
        if (binding.action == &action) keys.push_back(binding.key);
    return keys;
}

std::string KeyMap::hint(std::string_view action_name) const {
    const Action* const row = &action(action_name);
    const Binding* shown = nullptr;
    for (const Binding& binding : bindings_)
        if (binding.action == row && (!shown || (shown->is_default && !binding.is_default)))
            shown = &binding;
    return shown ? shown_key(shown->key) : std::string{};
}

std::string KeyMap::keys_of(const HelpLine& line) const {
    const std::vector<const Action*> shared = actions_of(line);
    const auto is_default = [this](const Action* row) {
        return keys_of(*row) == default_keys(*row);
    };
    if (!line.keys.empty() && std::ranges::all_of(shared, is_default))
        return std::string(line.keys);
    std::string keys;
    for (const Action* row : shared)
        if (const std::string key = hint(row->name); !key.empty())
            keys += (keys.empty() ? "" : " ") + key;
    return keys;
}

std::vector<HelpSection> KeyMap::help(PlayKind kind, std::span<const HelpWords> words) const {
    std::vector<HelpSection> sections;
    const auto add = [&](const HelpLine& line) {
        if (!(line.pages & help_bit(kind))) return;
        std::string keys = keys_of(line);
        const auto own = std::ranges::find(words, line.actions, &HelpWords::actions);
        const std::string_view help = own == words.end() ? line.help : own->help;
        if (keys.empty() || help.empty()) return;
        if (sections.empty() || sections.back().title != line.section)
            sections.push_back({std::string(line.section), {}});
        sections.back().keys.push_back({std::move(keys), std::string(help)});
    };
    std::ranges::for_each(help_lines(), add);
    std::ranges::for_each(unnamed_lines(actions()), add);
    return sections;
}

}  // namespace carom
