#pragma once

#include "model/painting/stroke_list.h"

#include <QByteArray>

#include <memory>
#include <vector>

namespace suffuse {

enum class PaperKind : std::uint8_t { None, Procedural, Image };
/// What the procedural paper is made of.
enum class PaperGrain : std::uint8_t { Tooth, Fibres, Weave };

/// An image as its encoded file bytes (PNG, JPEG, TIFF, WebP or EXR); decoding is the renderer's.
using EncodedImage = std::shared_ptr<const QByteArray>;

/// The paper's texture η (eq 16); docs/paper.md defines it. strength 0 or kind None: η = 1.
struct Paper {
    PaperKind kind = PaperKind::None;
    std::uint32_t seed = 1;
    float scale = 24;       ///< procedural: wavelength of the coarsest octave, a thread's width, units; image: units per image pixel; (0, 1e6]
    float strength = 0.5f;  ///< [0, 1]
    EncodedImage image;     ///< for PaperKind::Image
    PaperGrain grain = PaperGrain::Tooth; ///< for PaperKind::Procedural
};
bool operator==(const Paper &a, const Paper &b);

/// The sheet: from (0, 0) at its top left corner, y down. What is painted beyond it is kept.
struct Canvas {
    double width = 1024;           ///< units, (0, 1e6]
    double height = 768;           ///< units, (0, 1e6]
    Colour background{0, 0, 0, 1}; ///< under all strokes; red, yellow, blue and opacity, each in [0, 1]: opaque white
    Paper paper;
    friend bool operator==(const Canvas &, const Canvas &) = default;
    /// All of it, units.
    Rect area() const { return Rect::of(0, 0, width, height); }
};

/// Strokes of a group stand together in the order.
struct Group {
    GroupId id = 0;      ///< 1 and above; of no other group
    QString name;        ///< as it was typed; may be empty, or another group's too
    GroupId parent = 0;  ///< the group that it lies in; 0: none
    bool visible = true; ///< and with it what lies in it
    bool locked = false; ///< and with it what lies in it: seen, and not changed by tools
    friend bool operator==(const Group &, const Group &) = default;
};

/// A colour of the painting's palette; their order is the palette's.
struct Swatch {
    QString name;  ///< may be empty, or another's too
    Colour colour; ///< red, yellow, blue and opacity, each in [0, 1]
    friend bool operator==(const Swatch &, const Swatch &) = default;
};

/// A picture to paint over; never part of the rendered picture.
struct Underlay {
    EncodedImage image;
    Rect area;            ///< where it lies, canvas units
    float opacity = 0.5f; ///< [0, 1]
    bool visible = true;
};
bool operator==(const Underlay &a, const Underlay &b);

/// The painting: an immutable value once it is shared. Strokes stand from bottom to top.
struct Painting {
    Canvas canvas;
    StrokeList strokes;                       ///< ids 1 and above, each once
    std::vector<Group> groups;                ///< in any order; parents make no circles
    std::vector<Swatch> swatches;             ///< the palette, in its order
    std::shared_ptr<const Underlay> underlay; ///< null: none

    /// Null where there is none.
    StrokePtr find(StrokeId id) const;
    /// Position in the order, or -1.
    int indexOf(StrokeId id) const;
    /// Visible itself and in visible groups only.
    bool isVisible(const Stroke &stroke) const;
    /// Locked itself or in a locked group.
    bool isLocked(const Stroke &stroke) const;
    /// Of all strokes, hidden ones too.
    std::size_t segmentCount() const;
    /// The moment when all has dried, µs: the default document time. 0 without strokes.
    Microseconds end() const;
    StrokeId nextStrokeId() const; ///< greatest id + 1
};
/// The ids of the strokes, bottom to top.
std::vector<StrokeId> orderOf(const Painting &painting);
/// Deep equality: values, not pointers.
bool operator==(const Painting &a, const Painting &b);

using PaintingPtr = std::shared_ptr<const Painting>;

/// Hash over everything that a file holds; equal paintings have equal hashes. 32 bytes (SHA-256).
QByteArray hashOf(const Painting &painting);

} // namespace suffuse
