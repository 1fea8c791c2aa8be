#include <fmt/format.h>

#include <iterator>

#include "compiler/smesh/smesh.hpp"

namespace toile {

std::string emit(const SMesh& mesh, const Garment& garment) {
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  const Topology& t = mesh.topology;
  fmt::format_to(to, "smesh {}: {} vertices, {} edges, {} triangles\n", garment.name, t.vertices, t.edges, t.triangles);
  fmt::format_to(to, "topology: components {}, boundary loops {}, euler {}, {}, {}\n", t.components, t.boundary_loops,
                 t.euler, t.orientable ? "orientable" : "not orientable", t.manifold ? "manifold" : "not manifold");
  for (const SMesh::WornLine& line : mesh.worn) {
    fmt::format_to(to, "worn at {}: {} {:.4f} mm\n ", garment.wears[line.wear].line, line.closed ? "loop" : "open",
                   line.length * 1000);
    for (const int v : line.vertices) fmt::format_to(to, " {}", v);
    fmt::format_to(to, "\n  at:");
    for (const double s : line.arc) fmt::format_to(to, " {:.4f}", s * 1000);
    fmt::format_to(to, "\n");
  }
  for (int v = 0; v < mesh.vertex_count; ++v) {
    fmt::format_to(to, "v {}:", v);
    for (const int p : mesh.p_of_s[v]) fmt::format_to(to, " {}", p);
    fmt::format_to(to, "\n");
  }
  for (const SMesh::Edge& edge : mesh.edges) {
    fmt::format_to(to, "e {} {}:", edge.vertices[0], edge.vertices[1]);
    for (const SMesh::Wing wing : edge.wings) fmt::format_to(to, " {}", wing.triangle);
    if (edge.seam >= 0) fmt::format_to(to, " seam {}", garment.seams[edge.seam].name);
    fmt::format_to(to, "\n");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    fmt::format_to(to, "t {} {} {} {}\n", i, a, b, c);
  }
  return fmt::to_string(out);
}

}  // namespace toile
