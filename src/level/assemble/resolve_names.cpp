#include "level/assemble/resolve_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/elementary.h"
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

bool are_same(const Material& a, const Material& b) {
    return a.restitution == b.restitution && a.soften == b.soften && a.friction == b.friction &&
           a.kick == b.kick && a.kick_from == b.kick_from &&
           a.kicks_in_the_middle == b.kicks_in_the_middle;
}

// Finds the kinds or the materials of a level by name, and records which are used.
class Classes {
  public:
    explicit Classes(const std::vector<std::string_view>& names) : used_(names.size(), false) {
        for (std::size_t i = 0; i < names.size(); ++i)
            index_.emplace(names[i], i);
    }

    std::optional<ClassIndex> find(std::string_view name) {
        const auto found = index_.find(name);
        if (found == index_.end()) return std::nullopt;
        used_[found->second] = true;
        return static_cast<ClassIndex>(found->second);
    }
    bool has(std::string_view name) const { return index_.contains(name); }
    /// The default class, of balls or edges that name none.
    ClassIndex default_class() {
        is_default_used_ = true;
        return static_cast<ClassIndex>(used_.size());
    }
    bool is_default_used() const { return is_default_used_; }
    bool is_used(std::size_t i) const { return used_[i]; }

  private:
    std::map<std::string_view, std::size_t> index_;
    std::vector<bool> used_;
    bool is_default_used_ = false;
};

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
        make_collision_matrix();
        warn_unused();
        return std::move(result_);
    }

  private:
    // Searching for a similar name takes time, so it is done only for the first messages.
    std::string remedy(const Word& word, const std::vector<std::string_view>& known,
                       std::string otherwise) const {
        if (context_.reporter.errors() > 10 * max_diagnostics) return otherwise;
        return did_you_mean(word.text, known, std::move(otherwise));
    }

    ResolvedBalls resolve_kind(const std::optional<Word>& name) {
        if (!name) return {kinds_.default_class(), true};
        if (const auto kind = kinds_.find(name->text)) {
            return {*kind, ir_.kinds[*kind].is_valid};
        }
        context_.reporter.error(
            "unknown-kind", name->span(), fmt::format("there is no kind '{}'", name->text),
            remedy(*name, kind_names_, fmt::format("define it: kind {} r=...", name->text)));
        return {0, false};
    }

    std::optional<ClassIndex> known_material(const Word& name) {
        if (const auto material = materials_.find(name.text)) return material;
        context_.reporter.error(
            "unknown-material", name.span(), fmt::format("there is no material '{}'", name.text),
            remedy(name, material_names_, fmt::format("define it: material {} e=...", name.text)));
        return std::nullopt;
    }

    ResolvedEdges resolve_edges(const EdgeBinding& binding) {
        ResolvedEdges edges;
        std::vector<Word> words = binding.plain;
        std::optional<Word> material = binding.material;
        if (binding.may_begin_with_material && !words.empty() &&
            (words.size() == 2 || materials_.has(words[0].text))) {
            material = words[0];
            words.erase(words.begin());
        }
        if (material) {
            const auto found = known_material(*material);
            edges.is_valid = found.has_value();
            edges.material = found.value_or(ClassIndex{0});
        } else if (binding.makes_edges && !binding.device_material) {
            edges.material = materials_.default_class();
        }
        if (binding.device_material) is_of_own_material_.push_back(!material);
        if (!words.empty()) take_name(words[0], binding.may_begin_with_material, edges);
        return edges;
    }

    // Takes a word before the points as a name, and warns if it resembles a material.
    void take_name(const Word& word, bool may_be_material, ResolvedEdges& edges) {
        if (!is_identifier(word.text)) {
            context_.reporter.error("not-a-name", word.span(),
                                    fmt::format("'{}' is not a name", word.text),
                                    "points are written x,y without spaces");
            edges.is_valid = false;
            return;
        }
        edges.name = std::string(word.text);
        edges.name_at = word.span();
        const auto near = nearest_word(word.text, material_names_);
        if (!may_be_material || !near || edges.material < material_names_.size()) return;
        context_.reporter.warning(
            "material-taken-for-name", word.span(),
            fmt::format("'{}' is no material, so it is taken for a name", word.text),
            fmt::format("did you mean '{}'?", *near));
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
            if (result_.material_names[i] == name && are_same(result_.materials[i], made))
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

    // Whether "ball" or "edge" in `collide` is both the name of one class and the word for all.
    bool is_ambiguous(const Word& word, std::string_view all, std::string_view name,
                      std::size_t of_its_sort) {
        if (word.text != all || name != all || of_its_sort == 1) return false;
        const bool is_declared = kinds_.has(all) || materials_.has(all);
        if (!is_declared) return false;
        context_.reporter.error("ambiguous-class", word.span(),
                                fmt::format("'{}' is the name of one, and the word for all", all),
                                fmt::format("call that one something else than {}", all));
        return true;
    }

    // The classes that a word of `collide` stands for; empty: an error, which is reported.
    const std::vector<std::size_t>& classes_of(const Word& word) {
        std::vector<std::size_t>& known = classes_[word.text];
        if (known.empty()) known = find_classes(word);
        return known;
    }

    std::vector<std::size_t> find_classes(const Word& word) {
        std::vector<std::size_t> classes;
        const std::size_t kinds = result_.kinds.size();
        for (std::size_t i = 0; i < kinds + result_.materials.size(); ++i) {
            const bool is_kind = i < kinds;
            const std::string& name =
                is_kind ? result_.kind_names[i] : result_.material_names[i - kinds];
            const std::string_view all = is_kind ? "ball" : "edge";
            if (is_ambiguous(word, all, name,
                             is_kind ? kinds_of_a_layer_ : result_.materials.size()))
                return {};
            if (word.text == all || word.text == name) classes.push_back(i);
        }
        kinds_.find(word.text);
        materials_.find(word.text);
        if (!classes.empty()) return classes;
        std::vector<std::string_view> known{"ball", "edge"};
        known.insert(known.end(), kind_names_.begin(), kind_names_.end());
        known.insert(known.end(), material_names_.begin(), material_names_.end());
        context_.reporter.error(
            "unknown-class", word.span(),
            fmt::format("'{}' is neither a kind nor a material", word.text),
            remedy(word, known, "name kinds, materials, or the words ball and edge"));
        return {};
    }

    void make_collision_matrix() {
        if (ir_.collides.empty() && result_.layers == 1) return;
        const std::size_t kinds = result_.kinds.size();
        const std::size_t classes = kinds + result_.materials.size();
        result_.collision_matrix.assign(classes * classes, ir_.collides.empty() ? 1 : 0);
        add_declared_collisions();
        const auto layer_of = [&](std::size_t i) {
            return i < kinds ? result_.kinds[i].layer : result_.material_layers[i - kinds];
        };
        for (std::size_t i = 0; i < classes; ++i)
            for (std::size_t k = 0; k < classes; ++k)
                if (layer_of(i) != layer_of(k)) result_.collision_matrix[i * classes + k] = 0;
    }

    void add_declared_collisions() {
        const std::size_t kinds = result_.kinds.size();
        const std::size_t classes = kinds + result_.materials.size();
        // Handle each pair of words once: `ball ball` alone can be a million pairs of kinds.
        std::set<std::pair<std::string_view, std::string_view>> done;
        for (const CollideIr& collide : ir_.collides) {
            if (!done.emplace(collide.a.text, collide.b.text).second) continue;
            const std::vector<std::size_t>& a = classes_of(collide.a);
            const std::vector<std::size_t>& b = classes_of(collide.b);
            for (const std::size_t i : a) {
                for (const std::size_t k : b) {
                    result_.collision_matrix[i * classes + k] =
                        result_.collision_matrix[k * classes + i] = 1;
                }
            }
            const auto is_edge = [&](std::size_t i) { return i >= kinds; };
            if (!a.empty() && !b.empty() && std::ranges::all_of(a, is_edge) &&
                std::ranges::all_of(b, is_edge)) {
                context_.reporter.error("edges-with-edges", collide.b.span(),
                                        "edges do not meet edges",
                                        "name a kind of ball, or the word ball");
            }
        }
    }

    void warn_unused() {
        // A statement with an error may be the one that uses the name.
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
    Classes kinds_;
    Classes materials_;
    std::size_t kinds_of_a_layer_ = 0;
    std::vector<bool> is_of_own_material_;  ///< for each binding of a device
    std::map<std::string_view, std::vector<std::size_t>> classes_;  ///< for each word of `collide`
    ResolvedNames result_;
};

}  // namespace

bool ResolvedNames::kinds_collide(ClassIndex a, ClassIndex b) const {
    return collision_matrix.empty() ||
           collision_matrix[a * (kinds.size() + materials.size()) + b] != 0;
}

bool ResolvedNames::kind_collides_with(ClassIndex kind, ClassIndex material) const {
    return collision_matrix.empty() ||
           collision_matrix[kind * (kinds.size() + materials.size()) + kinds.size() + material] !=
               0;
}

bool ResolvedNames::some_balls_collide() const {
    for (std::size_t a = 0; a < kinds.size(); ++a) {
        for (std::size_t b = 0; b < kinds.size(); ++b) {
            if (kinds_collide(static_cast<ClassIndex>(a), static_cast<ClassIndex>(b))) return true;
        }
    }
    return false;
}

bool ResolvedNames::some_edges_collide() const {
    for (std::size_t a = 0; a < kinds.size(); ++a) {
        for (std::size_t m = 0; m < materials.size(); ++m) {
            if (kind_collides_with(static_cast<ClassIndex>(a), static_cast<ClassIndex>(m))) {
                return true;
            }
        }
    }
    return false;
}

bool ResolvedNames::all_collide() const {
    // The entries for two materials do not count: edges do not collide with edges.
    const std::size_t classes = kinds.size() + materials.size();
    for (std::size_t i = 0; i < collision_matrix.size(); ++i) {
        if (collision_matrix[i] == 0 &&
            (i / classes < kinds.size() || i % classes < kinds.size())) {
            return false;
        }
    }
    return true;
}

ResolvedNames resolve_names(Context& context) {
    return Resolver(context).resolve();
}

}  // namespace carom
