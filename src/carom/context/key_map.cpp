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

/// The group that contains the action; null: none.
const ActionGroup* group_of(const Action& wanted) {
    for (const ActionGroup& group : action_groups())
        if (&action(group.first) <= &wanted && &wanted <= &action(group.last)) return &group;
    return nullptr;
}

HelpSection& section_named(std::vector<HelpSection>& sections, std::string_view title,
                           std::string_view after) {
    const auto found = std::ranges::find(sections, title, &HelpSection::title);
    if (found != sections.end()) return *found;
    const auto before = std::ranges::find(sections, after, &HelpSection::title);
    const auto place = before == sections.end() ? before : std::next(before);
    return *sections.insert(place, {std::string(title), {}});
}

}  // namespace

KeyMap::KeyMap() {
    for (const Action& action : actions())
        for (const Key& key : default_keys(action))
            bind(key, &action);
}

void KeyMap::bind(const Key& key, const Action* action) {
    std::erase_if(bindings_, [&](const Binding& binding) {
        return binding.key == key && (!action || layer_of(*binding.action) == layer_of(*action));
    });
    if (action) bindings_.push_back({key, action});
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
    const auto found = std::ranges::find(bindings_, &action(action_name), &Binding::action);
    return found == bindings_.end() ? std::string{} : shown_key(found->key);
}

bool KeyMap::has_default_keys(const ActionGroup& group) const {
    const Action* const last = &action(group.last);
    for (const Action* row = &action(group.first); row <= last; ++row)
        if (keys_of(*row) != default_keys(*row)) return false;
    return true;
}

KeyHelp KeyMap::line_of(const Action& action) const {
    std::string keys;
    for (const Key& key : keys_of(action))
        keys += (keys.empty() ? "" : " ") + shown_key(key);
    return {keys, std::string(action.help)};
}

std::vector<HelpSection> KeyMap::help() const {
    std::vector<HelpSection> sections;
    for (const Action& row : actions()) {
        if (sections.empty() || sections.back().title != row.section)
            sections.push_back({std::string(row.section), {}});
        std::vector<KeyHelp>& lines = sections.back().keys;
        if (const ActionGroup* group = group_of(row); group && has_default_keys(*group)) {
            if (row.name == group->first)
                lines.push_back({std::string(group->keys), std::string(group->help)});
            continue;
        }
        if (KeyHelp line = line_of(row); !line.keys.empty()) lines.push_back(std::move(line));
    }
    for (const HelpNote& note : help_notes()) {
        KeyHelp line{std::string(note.keys), std::string(note.help)};
        if (!note.action.empty()) line.keys = line_of(action(note.action)).keys;
        if (line.keys.empty()) continue;
        section_named(sections, note.section, note.after).keys.push_back(std::move(line));
    }
    return sections;
}

}  // namespace carom
