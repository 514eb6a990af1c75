// The fortune-teller's parlour: walls, window and curtains, the table and what lies on it. Lengths in metres,
// y up, the floor at 0, the table in the middle.
#pragma once

#include <memory>
#include <vector>

#include "candlelight.h"
#include "room/mesh.h"
#include "room/texture.h"

namespace skinning {

inline constexpr glm::dvec3 kRoomMin{-1.75, 0.0, -2.2};
inline constexpr glm::dvec3 kRoomMax{1.75, 2.6, 2.4};
inline constexpr double kTableTop = 0.76;
inline constexpr double kTableRadius = 0.82;
inline constexpr double kPlinthHeight = 0.085;         // of the hand's foot on the table
inline constexpr glm::dvec3 kLamp{-0.20, 1.09, 1.15};  // the lamp outside the picture
inline constexpr glm::dvec3 kBall{0.40, kTableTop + 0.115, 0.22};
inline constexpr double kBallRadius = 0.082;
// The window's panes in the back wall.
inline constexpr glm::dvec3 kWindowCorner{-1.32, 1.06, kRoomMin.z + 0.03};
inline constexpr glm::dvec2 kWindowSize{0.78, 1.16};

enum class Surface {
  Lit,      // half the light in its vertices
  Table,    // the same; takes the hand's shadow
  Wall,     // the same, the wall behind the table
  Glowing,  // its color in its vertices
};

struct Part {
  Surface surface;
  const room::Texture* base;
  std::unique_ptr<room::Mesh> mesh;
};

class Parlour {
 public:
  Parlour();
  const std::vector<Part>& parts() const { return parts_; }
  // The crystal ball, about kBall; drawn as the hand is.
  const room::Mesh& ball() const { return *ball_; }
  const room::Texture& ballBase() const { return ballBase_; }
  // The tips of the candles that can be seen.
  const std::vector<glm::dvec3>& candles() const { return candles_; }

 private:
  void makeMaterials();
  void placeLights();
  // Each adds meshes and what they are to the light; the light is baked when all of them stand.
  void addTable();
  void addPlinth();
  void addCandle(glm::dvec3 foot, double stick, double wax);
  void addBooks();
  void addCards();
  void addBall();
  void addTeacup();
  void addBookcase();
  void addChair();
  void addWalls();
  void addWainscot();
  void addWindow();
  void addCurtain(double x, double z, double side);
  void addPictures();
  void addFlames();

  void finish(const room::Texture& base, const room::MeshData& data, Surface surface = Surface::Lit,
              glm::dvec3 tint = glm::dvec3(1));
  void addGlowing(const room::Texture& base, const room::MeshData& data,
                  const std::vector<glm::vec3>& colors);
  void addBook(const glm::dmat4& where, glm::dvec3 size, glm::dvec3 leather);

  struct Book {
    glm::dmat4 where;
    glm::dvec3 size, tint;
  };
  struct ShelvedBook {
    glm::dvec3 center, size, tint;
  };

  room::LightBake light_;
  room::Texture damask_, wood_, boards_, velvet_, cloth_, brass_, wax_, leather_, pages_, cards_, chart_,
      glass_, china_, ceiling_, sky_, white_, ballBase_;
  room::MeshData timber_, metal_, candleWax_, china3d_, tableCloth_;
  std::vector<Book> books_;
  std::vector<ShelvedBook> shelved_;
  std::vector<glm::dvec3> candles_;
  std::vector<Part> parts_;
  std::unique_ptr<room::Mesh> ball_;
};

}  // namespace skinning
