// Bodies: dress forms by sections and limbs, primitive shapes, meshes with lines; and their lines, once measured.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/evaluate/call.hpp"
#include "compiler/evaluate/session.hpp"

namespace toile {

/// Defines a `body` statement: a template when it has parameters, else the body itself.
void define_body(Session& session, Scope& scope, const syntax::Body& written);

Value instantiate(Session& session, const BodyTemplate& body, const std::vector<std::optional<Given>>& arguments);

/// The body that a value stands for: a body, or a template all of whose parameters have defaults. Null, with an error,
/// for anything else.
std::shared_ptr<BodyInstance> as_body(Session& session, const Value& value, Location at);

/// The names of a dress form's lines, and what is known of one from the form's sections alone; nothing for other bodies
/// and lines, which are measured.
std::optional<std::vector<std::string>> line_names(const BodySpec& body);
std::optional<BodyLineFacts> stated_line(const BodySpec& body, const std::string& name);

/// The lines of a body as the world measures them; null, with an error, when it cannot be made.
const std::vector<BodyLineFacts>* body_lines(Session& session, BodyInstance& body, Location at);

/// Its place among Program::bodies(), where it is entered when it is new.
int index_of(Session& session, BodyInstance& body);

}  // namespace toile
