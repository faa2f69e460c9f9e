#include "physics/laws/simultaneous_impact.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace carom {
namespace {

template <typename Real>
class Matrix {
  public:
    Matrix(std::size_t size, std::pmr::memory_resource* memory)
        : size_(size), values_(size * size, memory) {}
    Real& at(std::size_t row, std::size_t column) { return values_[row * size_ + column]; }
    const Real& at(std::size_t row, std::size_t column) const {
        return values_[row * size_ + column];
    }

  private:
    std::size_t size_;
    std::pmr::vector<Real> values_;
};

// How much the approach of contact i falls for an impulse of 1 at contact j.
template <typename Real>
Real coupling(const ImpactContact<Real>& i, const ImpactContact<Real>& j,
              std::span<const ImpactBody<Real>> bodies) {
    Real sum{};
    const auto add = [&](std::uint32_t x, std::uint32_t y, bool same_side, const Vector<Real>& ours,
                         const Vector<Real>& theirs) {
        if (x != y || x == ImpactContact<Real>::fixed) return;
        const Real part = dot(ours, theirs) * bodies[x].inverse_mass;
        sum += same_side ? part : -part;
    };
    add(i.a, j.a, true, i.normal, j.normal);
    add(i.a, j.b, false, i.normal, j.normal_of_b());
    add(i.b, j.a, false, i.normal_of_b(), j.normal);
    add(i.b, j.b, true, i.normal_of_b(), j.normal_of_b());
    return sum;
}

// Solves the rows and columns in `active`; the smallest solution where there are several. A small
// term on the diagonal makes the matrix definite, and iterative refinement removes the error that
// this causes. Pre: the diagonal is between 1 and 4.
template <typename Real>
std::pmr::vector<Real> solve(const Matrix<Real>& matrix, const std::pmr::vector<Real>& right,
                             const std::pmr::vector<std::size_t>& active) {
    const std::size_t count = active.size();
    const Real trace(1e-11);
    Real largest{};
    for (const std::size_t i : active)
        if (largest < absolute(right[i])) largest = absolute(right[i]);
    const Real rounding = largest * Real(precision<Real>);
    std::pmr::memory_resource* const memory = right.get_allocator().resource();
    Matrix<Real> root(count, memory);  // Cholesky
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            Real sum = matrix.at(active[i], active[j]);
            if (i == j) sum += trace;
            for (std::size_t k = 0; k < j; ++k)
                sum -= root.at(i, k) * root.at(j, k);
            root.at(i, j) = i == j ? square_root(sum > trace * Real(0.5) ? sum : trace * Real(0.5))
                                   : sum / root.at(j, j);
        }
    std::pmr::vector<Real> solution(count, memory);
    std::pmr::vector<Real> rest(count, memory);
    constexpr int most_rounds = 40;
    for (int round = 0; round < most_rounds; ++round) {
        Real worst{};
        for (std::size_t i = 0; i < count; ++i) {
            rest[i] = right[active[i]];
            for (std::size_t j = 0; j < count; ++j)
                rest[i] -= matrix.at(active[i], active[j]) * solution[j];
            if (worst < absolute(rest[i])) worst = absolute(rest[i]);
        }
        if (worst <= rounding) break;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < i; ++k)
                rest[i] -= root.at(i, k) * rest[k];
            rest[i] = rest[i] / root.at(i, i);
        }
        for (std::size_t i = count; i-- > 0;) {
            for (std::size_t k = i + 1; k < count; ++k)
                rest[i] -= root.at(k, i) * rest[k];
            rest[i] = rest[i] / root.at(i, i);
            solution[i] += rest[i];
        }
    }
    return solution;
}

// Pushing impulses that stop every approach, by block pivoting. Contacts whose impulse would pull
// leave the active set, and return when they approach again. When exchanging all of them at once
// makes no progress, one is exchanged at a time, the last (Judice and Pires, A block principal
// pivoting algorithm for linear complementarity problems, 1994). None if rounding keeps it from
// converging.
template <typename Real>
std::optional<std::pmr::vector<Real>> stopping_impulses(const Matrix<Real>& matrix,
                                                        const std::pmr::vector<Real>& approach) {
    const std::size_t count = approach.size();
    const Real largest = *std::max_element(approach.begin(), approach.end());
    const Real rounding = largest * Real(1e-12);
    constexpr int patience = 3;
    std::pmr::memory_resource* const memory = approach.get_allocator().resource();
    std::pmr::vector<std::uint8_t> is_active(count, 1, memory);
    std::pmr::vector<Real> impulses(count, memory);
    std::pmr::vector<std::size_t> active(memory);
    std::pmr::vector<std::size_t> wrong(memory);
    std::size_t fewest = count + 1;
    int tries = patience;
    const std::size_t most_rounds = 4 * count + 16;
    for (std::size_t round = 0; round < most_rounds; ++round) {
        active.clear();
        for (std::size_t i = 0; i < count; ++i)
            if (is_active[i]) active.push_back(i);
        const std::pmr::vector<Real> solution = solve(matrix, approach, active);
        std::fill(impulses.begin(), impulses.end(), Real{});
        wrong.clear();
        for (std::size_t i = 0; i < active.size(); ++i) {
            if (solution[i] < Real{}) wrong.push_back(active[i]);
            impulses[active[i]] = solution[i];
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (is_active[i]) continue;
            Real left = approach[i];
            for (const std::size_t j : active)
                left -= matrix.at(i, j) * impulses[j];
            if (left > rounding) wrong.push_back(i);
        }
        if (wrong.empty()) return impulses;
        if (wrong.size() < fewest) {
            fewest = wrong.size();
            tries = patience;
        } else {
            --tries;
        }
        if (tries >= 0)
            for (const std::size_t i : wrong)
                is_active[i] ^= 1;
        else
            is_active[*std::max_element(wrong.begin(), wrong.end())] ^= 1;
    }
    return std::nullopt;
}

// A power of two whose square is near `size`, from below: scaling by it rounds nothing.
template <typename Real>
Real scale_of(const Real& size) {
    Real scale(1.0);
    while (scale * scale * Real(4.0) <= size)
        scale = scale * Real(2.0);
    while (size < scale * scale)
        scale = scale * Real(0.5);
    return scale;
}

// Connected groups of more contacts than this are solved by relaxation.
constexpr std::size_t most_dense = 240;

// The result of a relaxation that has not converged is scaled so that energy is conserved with
// restitution 1, and falls with less, whatever approach is left.
template <typename Real>
std::pmr::vector<Real> relaxed_impulses(const std::pmr::vector<ImpactContact<Real>>& contacts,
                                        std::pmr::vector<ImpactBody<Real>> bodies) {
    std::pmr::memory_resource* const memory = contacts.get_allocator().resource();
    const std::pmr::vector<ImpactBody<Real>> before(bodies, memory);
    std::pmr::vector<Real> impulses(contacts.size(), memory);
    for (int round = 0; round < 400; ++round)
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const auto& contact = contacts[i];
            const Real stiffness = coupling<Real>(contact, contact, bodies);
            Real next = impulses[i] + approach_of<Real>(contact, bodies) / stiffness;
            if (next < Real{}) next = Real{};
            push<Real>(bodies, contact, next - impulses[i]);
            impulses[i] = next;
        }
    Real wanted{};
    Real given{};
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Real approach = approach_of<Real>(contacts[i], before);
        wanted += impulses[i] * approach;
        given += impulses[i] * (approach - approach_of<Real>(contacts[i], bodies));
    }
    if (given > Real{})
        for (Real& impulse : impulses)
            impulse = impulse * (wanted / given);
    return impulses;
}

// Groups of contacts connected through movable bodies, each in the order given.
template <typename Real>
std::pmr::vector<std::pmr::vector<std::uint32_t>> groups_of(
    std::span<const ImpactBody<Real>> bodies, std::span<const ImpactContact<Real>> contacts,
    std::pmr::memory_resource* memory) {
    std::pmr::vector<std::uint32_t> leader(bodies.size(), memory);
    std::iota(leader.begin(), leader.end(), 0u);
    const auto find = [&](std::uint32_t body) {
        while (leader[body] != body)
            body = leader[body] = leader[leader[body]];
        return body;
    };
    const auto moves = [&](std::uint32_t body) {
        return body != ImpactContact<Real>::fixed && bodies[body].inverse_mass > Real{};
    };
    for (const auto& contact : contacts)
        if (moves(contact.a) && moves(contact.b)) {
            const std::uint32_t a = find(contact.a);
            const std::uint32_t b = find(contact.b);
            leader[std::max(a, b)] = std::min(a, b);
        }
    std::pmr::vector<std::pmr::vector<std::uint32_t>> by_leader(bodies.size(), memory);
    for (std::uint32_t i = 0; i < contacts.size(); ++i)
        by_leader[find(moves(contacts[i].a) ? contacts[i].a : contacts[i].b)].push_back(i);
    std::erase_if(by_leader, [](const auto& group) { return group.empty(); });
    return by_leader;
}

}  // namespace

template <typename Real>
std::pmr::vector<Real> reflect(std::span<ImpactBody<Real>> bodies,
                               std::span<const ImpactContact<Real>> contacts,
                               std::pmr::memory_resource* memory) {
    std::pmr::vector<Real> passed(contacts.size(), memory);
    const auto reflect_one = [&](std::uint32_t index) {
        if (approach_of<Real>(contacts[index], bodies) > Real{})
            passed[index] = reflect_alone(bodies, contacts[index]);
    };
    if (contacts.size() == 1) {
        reflect_one(0);
        return passed;
    }
    for (const auto& group : groups_of<Real>(bodies, contacts, memory)) {
        const std::size_t count = group.size();
        if (count == 1) {
            reflect_one(group[0]);
            continue;
        }
        Real restitution = contacts[group[0]].restitution;
        for (const std::uint32_t index : group)
            if (contacts[index].restitution < restitution)
                restitution = contacts[index].restitution;
        std::optional<std::pmr::vector<Real>> impulses;
        if (count <= most_dense) {
            // Scaled to a diagonal of about 1, since masses may differ widely.
            Matrix<Real> matrix(count, memory);
            std::pmr::vector<Real> approach(count, memory);
            std::pmr::vector<Real> scale(count, memory);
            for (std::size_t i = 0; i < count; ++i) {
                const auto& contact = contacts[group[i]];
                scale[i] = scale_of(coupling<Real>(contact, contact, bodies));
                approach[i] = approach_of<Real>(contact, bodies) / scale[i];
            }
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < count; ++j)
                    matrix.at(i, j) =
                        coupling<Real>(contacts[group[i]], contacts[group[j]], bodies) /
                        (scale[i] * scale[j]);
            impulses = stopping_impulses(matrix, approach);
            for (std::size_t i = 0; impulses && i < count; ++i)
                (*impulses)[i] = (*impulses)[i] / scale[i];
        }
        if (!impulses) {
            std::pmr::vector<ImpactContact<Real>> own(memory);
            for (const std::uint32_t index : group)
                own.push_back(contacts[index]);
            impulses = relaxed_impulses(
                own, std::pmr::vector<ImpactBody<Real>>(bodies.begin(), bodies.end(), memory));
        }
        for (std::size_t i = 0; i < count; ++i) {
            passed[group[i]] = (Real(1.0) + restitution) * (*impulses)[i];
            push<Real>(bodies, contacts[group[i]], passed[group[i]]);
        }
    }
    return passed;
}

template std::pmr::vector<double> reflect(std::span<ImpactBody<double>>,
                                          std::span<const ImpactContact<double>>,
                                          std::pmr::memory_resource*);
template std::pmr::vector<DoubleDouble> reflect(std::span<ImpactBody<DoubleDouble>>,
                                                std::span<const ImpactContact<DoubleDouble>>,
                                                std::pmr::memory_resource*);

}  // namespace carom
