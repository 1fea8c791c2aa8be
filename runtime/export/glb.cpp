// glTF 2.0 binary (Khronos specification 2.0.1): one node and mesh, a primitive for each garment worn, everything
// embedded.
#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/export/export.hpp"
#include "runtime/export/little_endian.hpp"
#include "runtime/export/split_surface.hpp"
#include "runtime/export/textile_image.hpp"
#include "runtime/png/png.hpp"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

// Enumerants of the specification, section 5.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;

/// A turn from z up to glTF's y up; the wearer then faces +z, as glTF asks of a model's front.
Vec3 y_up(Vec3 p) {
  return {p.x, p.z, -p.y};
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

/// The binary chunk and the JSON that describes it, grown view by view.
class Buffer {
 public:
  /// Closes a view over what was appended to `bytes` since the last one; 4-aligned.
  int close_view(int target) {
    Json view{{"buffer", 0}, {"byteOffset", start_}, {"byteLength", bytes.size() - start_}};
    if (target != 0) view["target"] = target;
    views.push_back(std::move(view));
    pad(bytes, '\0');
    start_ = bytes.size();
    return static_cast<int>(views.size()) - 1;
  }
  int add_accessor(int target, int component, std::size_t count, std::string_view type) {
    accessors.push_back(
        {{"bufferView", close_view(target)}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors.size()) - 1;
  }

  std::string bytes;
  Json views = Json::array();
  Json accessors = Json::array();

 private:
  std::size_t start_ = 0;
};

int add_positions(Buffer& buffer, const std::vector<Vec3>& positions) {
  std::array<float, 3> least{};
  std::array<float, 3> most{};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = y_up(positions[i]);
    const std::array<float, 3> point{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      append(buffer.bytes, point[axis]);
      least[axis] = i == 0 ? point[axis] : std::min(least[axis], point[axis]);
      most[axis] = i == 0 ? point[axis] : std::max(most[axis], point[axis]);
    }
  }
  const int accessor = buffer.add_accessor(kArrayBuffer, kFloat, positions.size(), "VEC3");
  buffer.accessors.back()["min"] = least;
  buffer.accessors.back()["max"] = most;
  return accessor;
}

int add_normals(Buffer& buffer, const std::vector<Vec3>& normals) {
  for (const Vec3& normal : normals) {
    const Vec3 n = y_up(normal);
    for (const double value : {n.x, n.y, n.z}) append(buffer.bytes, static_cast<float>(value));
  }
  return buffer.add_accessor(kArrayBuffer, kFloat, normals.size(), "VEC3");
}

int layer_of(const PMesh& mesh, PieceId piece) {
  return mesh.layer_of_piece.empty() ? 0 : mesh.layer_of_piece[static_cast<std::size_t>(piece)];
}

int add_texture_coordinates(Buffer& buffer, const std::vector<Vec2>& uv, const PMesh& mesh,
                            const std::vector<TextileImage>& textiles) {
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const TextileImage& textile = textiles[static_cast<std::size_t>(layer_of(mesh, mesh.piece_of_point[i]))];
    append(buffer.bytes, static_cast<float>(uv[i].x / textile.repeat_u));
    append(buffer.bytes, static_cast<float>(uv[i].y / textile.repeat_v));
  }
  return buffer.add_accessor(kArrayBuffer, kFloat, uv.size(), "VEC2");
}

/// The triangles of one of the garments that are worn over each other.
int add_indices(Buffer& buffer, const std::vector<std::array<int, 3>>& triangles, const PMesh& mesh, int layer) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (layer_of(mesh, mesh.piece_of_triangle[t]) != layer) continue;
    for (const int corner : triangles[t]) append(buffer.bytes, static_cast<std::uint32_t>(corner));
    ++count;
  }
  return buffer.add_accessor(kElementArrayBuffer, kUnsignedInt, 3 * count, "SCALAR");
}

/// Cloth: rough, without metal, seen from both sides, with the soft edge light of its fibres in its own colour.
Json material(const Textile& textile, const TextileImage& image, std::size_t texture) {
  constexpr double kSheen = 0.5;
  const std::array<double, 3> sheen{kSheen * image.mean[0], kSheen * image.mean[1], kSheen * image.mean[2]};
  return {{"name", textile.name},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorTexture", {{"index", texture}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
          {"extensions", {{"KHR_materials_sheen", {{"sheenColorFactor", sheen}, {"sheenRoughnessFactor", 0.6}}}}}};
}

/// Which triangles, in the primitive's order, are of which piece.
Json piece_extents(const Garment& garment, const PMesh& mesh) {
  Json pieces = Json::array();
  const std::vector<PieceRange> ranges = piece_ranges(mesh, garment.pieces.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    pieces.push_back({{"name", garment.pieces[i].name},
                      {"first_triangle", ranges[i].first_triangle},
                      {"triangles", ranges[i].triangles}});
  }
  return pieces;
}

void append_chunk(std::string& file, std::string_view type, const std::string& content) {
  append(file, static_cast<std::uint32_t>(content.size()));
  file += type;
  file += content;
}

std::string container(std::string json, const std::string& binary) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  pad(json, ' ');
  std::string file = "glTF";
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(kHeader + 2 * kChunkHeader + json.size() + binary.size()));
  append_chunk(file, "JSON", json);
  append_chunk(file, std::string_view("BIN\0", 4), binary);
  return file;
}

}  // namespace

std::string glb(const DrapedGarment& draped) {
  const Garment& garment = *draped.garment;
  const SplitSurface surface = split_surface(*draped.mesh, draped.drape->positions);
  std::vector<Textile> textiles;
  for (const WornLayer& layer : garment.layers) textiles.push_back(layer.textile);
  if (textiles.empty()) textiles.push_back(garment.textile);
  std::vector<TextileImage> images;
  for (const Textile& textile : textiles) images.push_back(textile_image(textile));

  Buffer buffer;
  const int positions = add_positions(buffer, surface.positions);
  const int normals = add_normals(buffer, surface.normals);
  const int uv = add_texture_coordinates(buffer, surface.uv, draped.mesh->p, images);
  const Json attributes{{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}};
  Json primitives = Json::array(), materials = Json::array(), textures = Json::array(), pictures = Json::array();
  for (std::size_t layer = 0; layer < images.size(); ++layer) {
    const int indices = add_indices(buffer, surface.triangles, draped.mesh->p, static_cast<int>(layer));
    buffer.bytes += png(images[layer].image);
    primitives.push_back({{"attributes", attributes}, {"indices", indices}, {"material", layer}});
    materials.push_back(material(textiles[layer], images[layer], layer));
    textures.push_back({{"sampler", 0}, {"source", layer}});
    pictures.push_back({{"bufferView", buffer.close_view(0)}, {"mimeType", "image/png"}});
  }
  const Json root{
      {"asset", {{"version", "2.0"}, {"generator", "toile " TOILE_VERSION}}},
      {"extensionsUsed", Json::array({"KHR_materials_sheen"})},
      {"scene", 0},
      {"scenes", Json::array({{{"name", garment.name}, {"nodes", Json::array({0})}}})},
      {"nodes", Json::array({{{"name", garment.name}, {"mesh", 0}}})},
      {"meshes", Json::array({{{"name", garment.name},
                               {"primitives", primitives},
                               {"extras", {{"pieces", piece_extents(garment, draped.mesh->p)}}}}})},
      {"materials", materials},
      {"textures", textures},
      {"images", pictures},
      {"samplers",
       Json::array(
           {{{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", kRepeat}, {"wrapT", kRepeat}}})},
      {"accessors", buffer.accessors},
      {"bufferViews", buffer.views},
      {"buffers", Json::array({{{"byteLength", buffer.bytes.size()}}})}};
  return container(root.dump(-1, ' ', false, Json::error_handler_t::replace), buffer.bytes);
}

}  // namespace toile
