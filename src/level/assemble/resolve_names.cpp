#include "level/assemble/resolve_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "geometry/elementary.h"
#include "level/assemble/collision_matrix.h"
#include "level/text/spelling.h"

namespace carom {
namespace {

template <typename Spec>
std::vector<std::string_view> names_of(const std::vector<Spec>& specs) {
    std::vector<std::string_view> names;
    for (const Spec& spec : specs)
        names.push_back(spec.name.text);
    return names;
}

class Resolver {
  public:
    explicit Resolver(Context& context)
        : context_(context),
          ir_(context.ir),
          kind_names_(names_of(ir_.kinds)),
          material_names_(names_of(ir_.materials)),
          kinds_(kind_names_),
          materials_(material_names_) {}

    ResolvedNames resolve() {
        collect_rule_names();
        for (const EdgeBinding& binding : ir_.edge_bindings) {
            result_.edges.push_back(resolve_edges(binding));
        }
        for (const BallBinding& binding : ir_.ball_bindings) {
            result_.balls.push_back(resolve_kind(binding.kind));
        }
        for (const FillIr& fill : ir_.fills)
            result_.fills.push_back(resolve_kind(fill.kind));
        for (const EmitterIr& emitter : ir_.emitters) {
            result_.emitters.push_back(resolve_kind(emitter.kind));
        }
        make_classes();
        make_device_materials();
        result_.collision_matrix = make_collision_matrix(ir_, result_, kinds_of_a_layer_, kinds_,
                                                         materials_, context_.reporter);
        warn_unused();
        return std::move(result_);
    }

  private:
    // The name of a group: lanes of lanes.2.
    static std::string_view base_of(std::string_view name) {
        return name.substr(0, name.find('.'));
    }

    void collect_rule_names() {
        for (const RuleIr& rule : ir_.rules) {
            rule_names_.insert(base_of(rule.subject.text));
            if (rule.other) rule_names_.insert(rule.other->text);
            collect(rule.names);
        }
        for (const TaskIr& task : ir_.tasks)
            collect(task.names);
        for (const GoalIr& goal : ir_.goals)
            collect(goal.names);
        for (const AmendmentIr& amendment : ir_.amendments)
            if (amendment.name) rule_names_.insert(base_of(amendment.name->text));
    }
    void collect(const std::vector<RuleNameIr>& names) {
        for (const RuleNameIr& name : names)
            rule_names_.insert(base_of(name.word.text));
    }

    ResolvedBalls resolve_kind(const std::optional<Word>& name) {
        if (!name) return {kinds_.default_class(), true};
        if (const auto kind = kinds_.find(name->text)) {
            return {*kind, ir_.kinds[*kind].is_valid};
        }
        context_.reporter.error(
            "unknown-kind", name->span(), fmt::format("there is no kind '{}'", name->text),
            suggestion(name->text, kind_names_, fmt::format("define it: kind {} r=...", name->text),
                       context_.reporter));
        return {0, false};
    }

    std::optional<ClassIndex> known_material(const Word& name) {
        if (const auto material = materials_.find(name.text)) return material;
        context_.reporter.error(
            "unknown-material", name.span(), fmt::format("there is no material '{}'", name.text),
            suggestion(name.text, material_names_,
                       fmt::format("define it: material {} e=...", name.text), context_.reporter));
        return std::nullopt;
    }

    ResolvedEdges resolve_edges(const EdgeBinding& binding) {
        ResolvedEdges edges;
        std::vector<Word> words = binding.plain;
        std::optional<Word> material = binding.material;
        if (!has_one_of_each(binding)) {
            edges.is_valid = false;
            return edges;
        }
        if (binding.may_begin_with_material && !words.empty() && !material &&
            (words.size() == 2 || binding.name || materials_.has(words[0].text))) {
            material = words[0];
            words.erase(words.begin());
        }
        if (binding.name) words = {*binding.name};
        if (material) {
            const auto found = known_material(*material);
            edges.is_valid = found.has_value();
            edges.material = found.value_or(ClassIndex{0});
        } else if (binding.makes_edges && !binding.device_material) {
            edges.material = materials_.default_class();
        }
        if (binding.device_material) is_of_own_material_.push_back(!material);
        if (!words.empty()) take_name(words[0], edges);
        if (edges.is_valid && binding.may_begin_with_material && !words.empty() && !binding.name &&
            !material && !binding.device_material)
            warn_of_material(words[0]);
        return edges;
    }

    // Reports a second material or name: one before the points, and one as a key.
    bool has_one_of_each(const EdgeBinding& binding) {
        if (!binding.may_begin_with_material || binding.plain.empty()) return true;
        const Word& first = binding.plain.front();
        if (binding.material && (binding.plain.size() == 2 || materials_.has(first.text))) {
            context_.reporter.error("material-twice", first.span(),
                                    fmt::format("the material stands here too: '{}'", first.text),
                                    "keep this word or material=");
            return false;
        }
        const std::size_t most = 2u - (binding.material ? 1u : 0u) - (binding.name ? 1u : 0u);
        if (binding.plain.size() <= most) return true;
        context_.reporter.error(
            "name-twice", binding.plain.back().span(),
            fmt::format("the name stands here too: '{}'", binding.plain.back().text),
            "keep this word or name=");
        return false;
    }

    // A lone word before the points that is no material may be a misspelt or forgotten one: the
    // edges would silently be elastic. A name that rules use is a name.
    void warn_of_material(const Word& word) {
        if (rule_names_.contains(word.text)) return;
        const auto near = nearest_word(word.text, material_names_);
        context_.reporter.warning(
            "material-taken-for-name", word.span(),
            fmt::format("'{}' is no material, so it is taken for a name", word.text),
            near
                ? fmt::format("did you mean '{}'? If it is a name, write name={}", *near, word.text)
                : fmt::format("define it: material {} e=..., or write name={}", word.text,
                              word.text));
    }

    void take_name(const Word& word, ResolvedEdges& edges) {
        if (!is_identifier(word.text)) {
            context_.reporter.error("not-a-name", word.span(),
                                    fmt::format("'{}' is not a name", word.text),
                                    "points are written x,y without spaces");
            edges.is_valid = false;
            return;
        }
        edges.name = std::string(word.text);
        edges.name_at = word.span();
    }

    void make_classes() {
        for (const KindIr& spec : ir_.kinds) {
            Kind kind;
            kind.radius = spec.radius.value_or(1.0);
            kind.mass =
                spec.mass.value_or(spec.density.value_or(1.0) * pi * kind.radius * kind.radius);
            kind.restitution = spec.restitution.value_or(1.0);
            kind.friction = spec.friction;
            result_.kinds.push_back(kind);
            result_.kind_names.emplace_back(spec.name.text);
        }
        for (const MaterialIr& spec : ir_.materials) {
            result_.materials.push_back(spec.values);
            result_.material_names.emplace_back(spec.name.text);
            result_.material_layers.push_back(spec.layer);
            result_.layers = std::max<std::size_t>(result_.layers, spec.layer + 1u);
        }
        if (kinds_.is_default_used() || result_.kinds.empty()) {
            result_.kinds.emplace_back();
            result_.kind_names.emplace_back("ball");
        }
        if (materials_.is_default_used() || result_.materials.empty()) {
            result_.materials.emplace_back();
            result_.material_names.emplace_back("edge");
            result_.material_layers.push_back(0);
        }
        kinds_of_a_layer_ = result_.kinds.size();
        for (std::size_t i = kinds_of_a_layer_; i < result_.layers * kinds_of_a_layer_; ++i) {
            Kind kind = result_.kinds[i % kinds_of_a_layer_];
            kind.layer = static_cast<std::uint8_t>(i / kinds_of_a_layer_);
            result_.kinds.push_back(kind);
            result_.kind_names.push_back(result_.kind_names[i % kinds_of_a_layer_]);
        }
    }

    // Gives pinball devices materials of their own: the default material of the device, or the
    // named one, with the kick of the device.
    void make_device_materials() {
        const std::size_t first = result_.materials.size();
        std::size_t part = 0;
        for (std::size_t i = 0; i < ir_.edge_bindings.size(); ++i) {
            const EdgeBinding& binding = ir_.edge_bindings[i];
            if (!binding.device_material) continue;
            const bool is_own = is_of_own_material_[part++];
            ResolvedEdges& edges = result_.edges[i];
            if (!edges.is_valid) continue;
            Material made = *binding.device_material;
            std::uint8_t layer = 0;
            if (!is_own) {
                layer = result_.material_layers[edges.material];
                const Material& named = result_.materials[edges.material];
                made.restitution = named.restitution;
                made.soften = named.soften;
                made.friction = named.friction;
            }
            const std::string name(is_own ? binding.node->statement->name
                                          : result_.material_names[edges.material]);
            edges.material =
                find_or_add_material(made, name, first, binding.node->keyword().span());
            result_.material_layers.resize(result_.materials.size(), layer);
        }
    }

    ClassIndex find_or_add_material(const Material& made, const std::string& name,
                                    std::size_t first, const Span& at) {
        for (std::size_t i = first; i < result_.materials.size(); ++i) {
            if (result_.material_names[i] == name && result_.materials[i] == made)
                return static_cast<ClassIndex>(i);
        }
        if (result_.kinds.size() + result_.materials.size() >= max_classes) {
            context_.reporter.error(
                "too-many-classes", at,
                fmt::format("the level has more than {} kinds and materials", max_classes),
                "let more parts have the same kick");
            return 0;
        }
        result_.materials.push_back(made);
        result_.material_names.push_back(name);
        return static_cast<ClassIndex>(result_.materials.size() - 1);
    }

    void warn_unused() {
        // The statement that uses the name may be one with an error.
        if (context_.reporter.has_errors()) return;
        const auto warn = [&](const Word& name, std::string_view what) {
            if (!name.source->included_from.empty() || name.source->name == "--set") return;
            context_.reporter.warning("unused-class", name.span(),
                                      fmt::format("the {} '{}' is never used", what, name.text),
                                      "use it, or take it out");
        };
        for (std::size_t i = 0; i < ir_.kinds.size(); ++i) {
            if (!kinds_.is_used(i) && ir_.kinds[i].is_valid) warn(ir_.kinds[i].name, "kind");
        }
        for (std::size_t i = 0; i < ir_.materials.size(); ++i) {
            if (!materials_.is_used(i)) warn(ir_.materials[i].name, "material");
        }
        for (const auto& [where, let] : context_.lets) {
            if (let.is_used || !let.span.source->included_from.empty()) continue;
            context_.reporter.warning("unused-let", let.span,
                                      fmt::format("'{}' is never used", let.name),
                                      "use it, or take it out");
        }
    }

    Context& context_;
    LevelIr& ir_;
    std::vector<std::string_view> kind_names_;
    std::vector<std::string_view> material_names_;
    ClassNames kinds_;
    ClassNames materials_;
    std::set<std::string_view> rule_names_;  ///< names that rules, `move` and `remove` use
    std::size_t kinds_of_a_layer_ = 0;
    std::vector<bool> is_of_own_material_;  ///< for each binding of a device
    ResolvedNames result_;
};

}  // namespace

ResolvedNames resolve_names(Context& context) {
    return Resolver(context).resolve();
}

}  // namespace carom
