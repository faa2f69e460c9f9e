#include "level/assemble/collision_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace carom {
namespace {

class MatrixBuilder {
  public:
    MatrixBuilder(const LevelIr& ir, const ResolvedNames& names, std::size_t kinds_of_a_layer,
                  ClassNames& kinds, ClassNames& materials, Reporter& reporter)
        : ir_(ir),
          names_(names),
          kinds_of_a_layer_(kinds_of_a_layer),
          kinds_(kinds),
          materials_(materials),
          reporter_(reporter) {}

    std::vector<std::uint8_t> make() {
        if (ir_.collides.empty() && names_.layers == 1) return {};
        const std::size_t kinds = names_.kinds.size();
        const std::size_t classes = kinds + names_.materials.size();
        matrix_.assign(classes * classes, ir_.collides.empty() ? 1 : 0);
        add_declared_collisions();
        const auto layer_of = [&](std::size_t i) {
            return i < kinds ? names_.kinds[i].layer : names_.material_layers[i - kinds];
        };
        for (std::size_t i = 0; i < classes; ++i)
            for (std::size_t k = 0; k < classes; ++k)
                if (layer_of(i) != layer_of(k)) matrix_[i * classes + k] = 0;
        return std::move(matrix_);
    }

  private:
    // Whether "ball" or "edge" in `collide` is both the name of one class and the word for all.
    bool is_ambiguous(const Word& word, std::string_view all, std::string_view name,
                      std::size_t of_its_sort) {
        if (word.text != all || name != all || of_its_sort == 1) return false;
        const bool is_declared = kinds_.has(all) || materials_.has(all);
        if (!is_declared) return false;
        reporter_.error("ambiguous-class", word.span(),
                        fmt::format("'{}' is the name of one, and the word for all", all),
                        fmt::format("call that one something else than {}", all));
        return true;
    }

    // The classes that a word of `collide` denotes; empty: an error, which is reported.
    const std::vector<std::size_t>& classes_of(const Word& word) {
        std::vector<std::size_t>& known = classes_[word.text];
        if (known.empty()) known = find_classes(word);
        return known;
    }

    std::vector<std::size_t> find_classes(const Word& word) {
        std::vector<std::size_t> classes;
        const std::size_t kinds = names_.kinds.size();
        for (std::size_t i = 0; i < kinds + names_.materials.size(); ++i) {
            const bool is_kind = i < kinds;
            const std::string& name =
                is_kind ? names_.kind_names[i] : names_.material_names[i - kinds];
            const std::string_view all = is_kind ? "ball" : "edge";
            if (is_ambiguous(word, all, name,
                             is_kind ? kinds_of_a_layer_ : names_.materials.size()))
                return {};
            if (word.text == all || word.text == name) classes.push_back(i);
        }
        kinds_.find(word.text);
        materials_.find(word.text);
        if (!classes.empty()) return classes;
        std::vector<std::string_view> known{"ball", "edge"};
        for (const KindIr& kind : ir_.kinds)
            known.push_back(kind.name.text);
        for (const MaterialIr& material : ir_.materials)
            known.push_back(material.name.text);
        reporter_.error("unknown-class", word.span(),
                        fmt::format("'{}' is neither a kind nor a material", word.text),
                        suggestion(word.text, known,
                                   "name kinds, materials, or the words ball and edge", reporter_));
        return {};
    }

    void add_declared_collisions() {
        const std::size_t kinds = names_.kinds.size();
        const std::size_t classes = kinds + names_.materials.size();
        // Handle each pair of words once: `ball ball` alone can be a million pairs of kinds.
        std::set<std::pair<std::string_view, std::string_view>> done;
        for (const CollideIr& collide : ir_.collides) {
            if (!done.emplace(collide.a.text, collide.b.text).second) continue;
            const std::vector<std::size_t>& a = classes_of(collide.a);
            const std::vector<std::size_t>& b = classes_of(collide.b);
            for (const std::size_t i : a) {
                for (const std::size_t k : b) {
                    matrix_[i * classes + k] = matrix_[k * classes + i] = 1;
                }
            }
            const auto is_edge = [&](std::size_t i) { return i >= kinds; };
            if (!a.empty() && !b.empty() && std::ranges::all_of(a, is_edge) &&
                std::ranges::all_of(b, is_edge)) {
                reporter_.error("edges-with-edges", collide.b.span(), "edges do not meet edges",
                                "name a kind of ball, or the word ball");
            }
        }
    }

    const LevelIr& ir_;
    const ResolvedNames& names_;
    std::size_t kinds_of_a_layer_;
    ClassNames& kinds_;
    ClassNames& materials_;
    Reporter& reporter_;
    std::map<std::string_view, std::vector<std::size_t>> classes_;  ///< for each word of `collide`
    std::vector<std::uint8_t> matrix_;
};

}  // namespace

std::vector<std::uint8_t> make_collision_matrix(const LevelIr& ir, const ResolvedNames& names,
                                                std::size_t kinds_of_a_layer, ClassNames& kinds,
                                                ClassNames& materials, Reporter& reporter) {
    return MatrixBuilder(ir, names, kinds_of_a_layer, kinds, materials, reporter).make();
}

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

}  // namespace carom
