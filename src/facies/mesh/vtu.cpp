// SPDX-License-Identifier: Apache-2.0
// Format: "VTK XML formats", https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html.
#include "facies/mesh/vtu.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <utility>
#include <zlib.h>

#include <fmt/format.h>

#include "facies/base/files.hpp"
#include "facies/mesh/surface.hpp"

namespace facies::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "the writer copies numbers as they are");

/// Cell types of VTK.
constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_quad = 9;
constexpr std::uint8_t vtk_hexahedron = 12;
constexpr std::uint8_t vtk_wedge = 13;
/// VTK's first wedge triangle looks out of the cell, ours into it.
constexpr std::array<std::size_t, 6> vtk_wedge_order{0, 2, 1, 3, 5, 4};

constexpr std::size_t block_size = std::size_t{1} << 18;
constexpr int compression_level =
    3;  // of 9; higher ones cost much time and save little on such numbers

struct Cells {
  std::vector<Index> connectivity;
  std::vector<Index> offsets;
  std::vector<std::uint8_t> types;

  void add(std::span<const Index> nodes, std::uint8_t type) {
    connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
    offsets.push_back(to_index(connectivity.size()));
    types.push_back(type);
  }
};

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// The field's numbers as they stand in the file.
template <class T>
std::string encode(std::span<const double> values) {
  std::vector<T> numbers;
  numbers.reserve(values.size());
  for (const double value : values) {
    if constexpr (std::is_integral_v<T>) {
      require(value == std::floor(value) && value >= double(std::numeric_limits<T>::min()) &&
                  value <= double(std::numeric_limits<T>::max()),
              "a field holds a value that its integer type cannot");
    }
    numbers.push_back(static_cast<T>(value));
  }
  return std::string(bytes_of(std::span<const T>(numbers)));
}

std::string encode(const Field& field) {
  switch (field.type) {
    case NumberType::float32:
      return encode<float>(field.values);
    case NumberType::float64:
      return encode<double>(field.values);
    case NumberType::int32:
      return encode<std::int32_t>(field.values);
    case NumberType::uint8:
      return encode<std::uint8_t>(field.values);
  }
  return {};
}

std::string_view type_name(NumberType type) {
  switch (type) {
    case NumberType::float32:
      return "Float32";
    case NumberType::float64:
      return "Float64";
    case NumberType::int32:
      return "Int32";
    case NumberType::uint8:
      return "UInt8";
  }
  return {};
}

std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// Data as VTK's compressor lays it out: number of blocks, size of a block, size of a last shorter block (0: none), size
/// of each block when compressed, then the blocks.
std::string compress_blocks(std::string_view data) {
  std::vector<std::uint64_t> header{(data.size() + block_size - 1) / block_size, block_size,
                                    data.size() % block_size};
  std::string blocks;
  std::string buffer(compressBound(block_size), '\0');
  while (!data.empty()) {
    const std::string_view block = data.substr(0, block_size);
    uLongf size = buffer.size();
    const int status =
        compress2(reinterpret_cast<Bytef*>(buffer.data()), &size,
                  reinterpret_cast<const Bytef*>(block.data()), block.size(), compression_level);
    require(status == Z_OK, "zlib cannot compress a block");
    header.push_back(size);
    blocks.append(buffer, 0, size);
    data.remove_prefix(block.size());
  }
  return std::string(bytes_of(std::span<const std::uint64_t>(header))) + blocks;
}

/// The two halves of the file: the XML that describes the arrays, and the arrays.
class VtuText {
 public:
  void line(std::string_view text) { xml_.append(text).push_back('\n'); }

  void array(std::string_view type, std::string_view attributes, std::string_view data) {
    line(fmt::format("        <DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>", type,
                     attributes, appended_.size()));
    appended_ += compress_blocks(data);
  }

  void fields(std::string_view element, std::span<const Field> fields, std::size_t n) {
    std::set<std::string> names;
    line(fmt::format("      <{}>", element));
    for (const Field& field : fields) {
      require(!field.name.empty() && names.insert(field.name).second,
              "a field has no name or the name of another one");
      require(field.n_components > 0 && field.values.size() == n * std::size_t(field.n_components),
              "a field has the wrong number of values");
      array(type_name(field.type), field_attributes(field), encode(field));
    }
    line(fmt::format("      </{}>", element));
  }

  [[nodiscard]] std::string finish() && {
    line("    </Piece>");
    line("  </UnstructuredGrid>");
    line("  <AppendedData encoding=\"raw\">");
    return xml_ + "_" + appended_ + "\n  </AppendedData>\n</VTKFile>\n";
  }

 private:
  static std::string field_attributes(const Field& field) {
    std::string text = fmt::format("Name=\"{}\"", escape(field.name));
    // Without the attribute a scalar stays a plain list in every reader.
    if (field.n_components == 1) return text;
    text += fmt::format(" NumberOfComponents=\"{}\"", field.n_components);
    if (field.n_components == 6) {
      int i = 0;
      for (const char* component : {"XX", "YY", "ZZ", "XY", "YZ", "XZ"}) {
        text += fmt::format(" ComponentName{}=\"{}\"", i++, component);
      }
    }
    return text;
  }

  std::string xml_;
  std::string appended_;
};

std::string make_vtu(std::span<const Vec3> points, const Cells& cells,
                     std::span<const Field> point_fields, std::span<const Field> cell_fields) {
  VtuText vtu;
  vtu.line("<?xml version=\"1.0\"?>");
  vtu.line(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">");
  vtu.line("  <UnstructuredGrid>");
  vtu.line(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", points.size(),
                       cells.types.size()));
  vtu.fields("PointData", point_fields, points.size());
  vtu.fields("CellData", cell_fields, cells.types.size());
  vtu.line("      <Points>");
  vtu.array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", bytes_of(points));
  vtu.line("      </Points>");
  vtu.line("      <Cells>");
  vtu.array("Int32", "Name=\"connectivity\"", bytes_of(std::span<const Index>(cells.connectivity)));
  vtu.array("Int32", "Name=\"offsets\"", bytes_of(std::span<const Index>(cells.offsets)));
  vtu.array("UInt8", "Name=\"types\"", bytes_of(std::span<const std::uint8_t>(cells.types)));
  vtu.line("      </Cells>");
  return std::move(vtu).finish();
}

/// A comment must not hold "--"; nothing else needs care in one.
std::string comment_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && safe.ends_with('-')) safe += ' ';
    safe += c;
  }
  return safe;
}

/// The rows of a field that belong to these nodes.
Field restricted(const Field& field, std::span<const Index> nodes, std::size_t n_nodes) {
  const auto n = static_cast<std::size_t>(std::max(field.n_components, 0));
  require(field.values.size() == n_nodes * n, "a field has the wrong number of values");
  Field part{field.name, field.n_components, {}, field.type};
  for (const Index node : nodes) {
    const auto row = field.values.begin() + std::ptrdiff_t(at(node) * n);
    part.values.insert(part.values.end(), row, row + std::ptrdiff_t(n));
  }
  return part;
}

}  // namespace

Field scalar_field(std::string name, std::span<const double> values, NumberType type) {
  return {std::move(name), 1, {values.begin(), values.end()}, type};
}

Field integer_field(std::string name, std::span<const int> values, NumberType type) {
  return {std::move(name), 1, {values.begin(), values.end()}, type};
}

Field vector_field(std::string name, std::span<const Vec3> values, NumberType type) {
  Field field{std::move(name), 3, {}, type};
  for (const Vec3& v : values)
    field.values.insert(field.values.end(), v.begin(), v.end());
  return field;
}

Field tensor_field(std::string name, std::span<const Sym3<double>> values, NumberType type) {
  Field field{std::move(name), 6, {}, type};
  for (const Sym3<double>& A : values) {
    const std::array<double, 6> components = A.components();
    field.values.insert(field.values.end(), components.begin(), components.end());
  }
  return field;
}

std::string to_vtu(const Mesh& mesh, std::span<const Vec3> x, std::span<const Field> node_fields,
                   std::span<const Field> element_fields) {
  require(x.size() == mesh.n_nodes(), "one position per node is needed");
  Cells cells;
  for (const Element& element : mesh.elements()) {
    if (element.type == CellType::hex8) {
      cells.add(element.connectivity(), vtk_hexahedron);
    } else {
      std::array<Index, 6> nodes{};
      for (std::size_t i = 0; i < 6; ++i)
        nodes[i] = element.nodes[vtk_wedge_order[i]];
      cells.add(nodes, vtk_wedge);
    }
  }
  return make_vtu(x, cells, node_fields, element_fields);
}

std::string to_vtu(const Mesh& mesh, std::span<const Face> faces, std::span<const Vec3> x,
                   std::span<const Field> node_fields, std::span<const Field> face_fields) {
  require(x.size() == mesh.n_nodes(), "one position per node is needed");
  const std::vector<Index> nodes = face_set_nodes(mesh, faces);
  std::vector<Index> number(mesh.n_nodes(), -1);
  std::vector<Vec3> points;
  for (const Index node : nodes) {
    number[at(node)] = to_index(points.size());
    points.push_back(x[at(node)]);
  }
  Cells cells;
  for (const Face& face : faces) {
    std::vector<Index> corners = mesh.face_nodes(face);
    for (Index& corner : corners)
      corner = number[at(corner)];
    cells.add(corners, corners.size() == 3 ? vtk_triangle : vtk_quad);
  }
  std::vector<Field> fields;
  for (const Field& field : node_fields) {
    fields.push_back(restricted(field, nodes, mesh.n_nodes()));
  }
  return make_vtu(points, cells, fields, face_fields);
}

std::string to_vtu(std::span<const Vec3> x, std::span<const std::array<Index, 3>> triangles,
                   std::span<const Field> point_fields, std::span<const Field> triangle_fields) {
  Cells cells;
  for (const std::array<Index, 3>& triangle : triangles)
    cells.add(triangle, vtk_triangle);
  return make_vtu(x, cells, point_fields, triangle_fields);
}

std::string to_pvd(std::span<const SeriesEntry> entries) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const SeriesEntry& entry : entries) {
    require(std::isfinite(entry.time), "a time of a series is not finite");
    if (!entry.remark.empty()) {
      xml += fmt::format("    <!-- {} -->\n", comment_text(entry.remark));
    }
    xml += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"{}\" file=\"{}\"/>\n",
                       entry.time, entry.part, escape(entry.file.generic_string()));
  }
  return xml + "  </Collection>\n</VTKFile>\n";
}

void write_vtu(const std::filesystem::path& path, const Mesh& mesh, std::span<const Vec3> x,
               std::span<const Field> node_fields, std::span<const Field> element_fields) {
  write_file(path, to_vtu(mesh, x, node_fields, element_fields));
}

void write_pvd(const std::filesystem::path& path, std::span<const SeriesEntry> entries) {
  write_file(path, to_pvd(entries));
}

}  // namespace facies::mesh
