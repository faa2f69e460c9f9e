#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"

namespace carom {
namespace {

// Whether the name is available for a kind or a material.
bool is_free(const Word& name, Context& context) {
    Reporter& reporter = context.reporter;
    if (!is_identifier(name.text)) {
        reporter.error("not-a-name", name.span(), fmt::format("'{}' is not a name", name.text),
                       "a name has letters, digits and '_', and begins with a letter");
        return false;
    }
    if (context.ir.kinds.size() + context.ir.materials.size() >= max_classes) {
        reporter.error("too-many-classes", name.span(),
                       fmt::format("the level has more than {} kinds and materials", max_classes),
                       "use fewer");
        return false;
    }
    const auto taken = [&](const Word& by, std::string_view holder) {
        if (by.text != name.text) return false;
        reporter.error("name-taken", name.span(),
                       taken_message(name.span(), name.text, holder, by.span()),
                       "give each kind and each material a name of its own");
        return true;
    };
    for (const KindIr& kind : context.ir.kinds) {
        if (taken(kind.name, "kind")) return false;
    }
    for (const MaterialIr& material : context.ir.materials) {
        if (taken(material.name, "material")) return false;
    }
    return true;
}

void declare_kind(const Arguments& arguments, const Frame&, Context& context) {
    if (arguments.plain.empty() || !is_free(arguments.plain.front(), context)) return;
    KindIr kind;
    kind.name = arguments.plain.front();
    kind.radius = arguments.number("r");
    kind.mass = arguments.number("m");
    kind.density = arguments.number("density");
    kind.restitution = arguments.number("e");
    kind.friction = arguments.number_or("mu", 0.0);
    kind.color = arguments.color();
    kind.is_valid = arguments.is_valid;
    context.ir.kinds.push_back(std::move(kind));
}

void declare_material(const Arguments& arguments, const Frame&, Context& context) {
    if (arguments.plain.empty() || !is_free(arguments.plain.front(), context)) return;
    context.ir.materials.push_back(
        {arguments.plain.front(),
         {arguments.number_or("e", 1.0), arguments.number_or("soften", 0.0),
          arguments.number_or("mu", 0.0)},
         static_cast<std::uint8_t>(arguments.number_or("layer", 0.0)),
         arguments.color()});
}

}  // namespace

std::vector<Statement> class_statements() {
    using enum KeyShape;
    using enum Bound;
    return {
        {.name = "kind",
         .usage = "kind NAME [r=] [m=] [density=] [e=] [mu=] [color=]",
         .action = declare_kind,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {keys::ball_radius,
                  keys::ball_mass,
                  {"density", scalar, Measure::density, positive},
                  keys::restitution,
                  keys::friction,
                  keys::color},
         .settable = Settable::by_name,
         .runs_with_errors = true},
        {.name = "material",
         .usage = "material NAME [e=] [soften=] [mu=] [layer=0..3] [color=]",
         .action = declare_material,
         .place = Place::top,
         .plain_least = 1,
         .plain_most = 1,
         .keys = {keys::restitution,
                  {"soften", scalar, Measure::soften, not_negative},
                  keys::friction,
                  {"layer", scalar, Measure::whole, layer},
                  keys::color},
         .settable = Settable::by_name,
         .runs_with_errors = true},
    };
}

}  // namespace carom
