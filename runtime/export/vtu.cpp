// VTK's XML format for unstructured grids, as ParaView and the like open it: the surface opened along its seams,
// strains and stresses of each triangle, places in warp and weft and pressures of each point.
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <vector>

#include "runtime/export/export.hpp"
#include "runtime/export/split_surface.hpp"
#include "runtime/field/field.hpp"

namespace toile {
namespace {

constexpr int a_line = 12;  // numbers

class DataArrays {
 public:
  explicit DataArrays(std::string& document) : document_(document) {}

  void reals(const std::string& name, const std::vector<double>& values, int components = 1) {
    open("Float64", name, components);
    for (std::size_t i = 0; i < values.size(); ++i) add(fmt::format("{:.9g}", values[i]), i);
    close();
  }
  void integers(const std::string& name, const std::vector<int>& values) {
    open("Int32", name, 1);
    for (std::size_t i = 0; i < values.size(); ++i) add(fmt::format("{}", values[i]), i);
    close();
  }
  void bytes(const std::string& name, int value, std::size_t times) {
    open("UInt8", name, 1);
    for (std::size_t i = 0; i < times; ++i) add(fmt::format("{}", value), i);
    close();
  }

 private:
  void open(const char* type, const std::string& name, int components) {
    const std::string each = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
    document_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">\n", type, name, each);
  }
  void add(const std::string& number, std::size_t place) {
    document_ += number;
    document_ += (place + 1) % a_line == 0 ? '\n' : ' ';
  }
  void close() { document_ += "\n</DataArray>\n"; }

  std::string& document_;
};

std::vector<double> coordinates(const std::vector<Vec3>& points) {
  std::vector<double> all;
  for (const Vec3 p : points) all.insert(all.end(), {p.x, p.y, p.z});
  return all;
}

}  // namespace

std::string vtu(const DrapedGarment& draped) {
  const SewnMesh& mesh = *draped.mesh;
  const SplitSurface surface = split_surface(mesh, draped.drape->positions);
  const auto values_of = [&](const std::string& name) { return field(name, *draped.cloth, *draped.drape).values; };

  std::string document = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<!-- Metres, z up. Points are repeated along seams: those of one sewn_vertex are one. Shear in radians, "
      "stresses "
      "in N/m, pressure in Pa. -->\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      surface.positions.size(), surface.triangles.size());
  DataArrays arrays(document);
  document += "<Points>\n";
  arrays.reals("points", coordinates(surface.positions), 3);
  document += "</Points>\n<Cells>\n";
  std::vector<int> corners, ends;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    ends.push_back(static_cast<int>(corners.size()));
  }
  constexpr int vtk_triangle = 5;
  arrays.integers("connectivity", corners);
  arrays.integers("offsets", ends);
  arrays.bytes("types", vtk_triangle, surface.triangles.size());
  document += "</Cells>\n<CellData>\n";
  for (const char* name :
       {"strain.warp", "strain.weft", "strain.shear", "stress.warp", "stress.weft", "stress.shear"}) {
    arrays.reals(name, values_of(name));
  }
  arrays.integers("piece", mesh.p.piece_of_triangle);
  document += "</CellData>\n<PointData>\n";
  std::vector<double> uv, pressure;
  const std::vector<double> of_sewn = values_of("contact.pressure");
  for (std::size_t i = 0; i < surface.uv.size(); ++i) {
    uv.insert(uv.end(), {surface.uv[i].x, surface.uv[i].y});
    pressure.push_back(of_sewn[static_cast<std::size_t>(mesh.s.s_of_p[i])]);
  }
  arrays.reals("uv", uv, 2);
  arrays.reals("contact.pressure", pressure);
  arrays.integers("sewn_vertex", mesh.s.s_of_p);
  return document + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace toile
