#pragma once

#include "model/stroke_list.h"

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

struct Canvas {
    double width = 1024;  ///< units, (0, 1e6]
    double height = 768;
    Colour background{0, 0, 0, 1};
    Paper paper;
    friend bool operator==(const Canvas &, const Canvas &) = default;
    Rect area() const { return Rect::of(0, 0, width, height); }
};

/// Strokes of a group stand together in the order.
struct Group {
    GroupId id = 0;
    QString name;
    GroupId parent = 0;
    bool visible = true;
    bool locked = false;
    friend bool operator==(const Group &, const Group &) = default;
};

struct Swatch {
    QString name;
    Colour colour;
    friend bool operator==(const Swatch &, const Swatch &) = default;
};

/// A picture to paint over; never part of the rendered picture.
struct Underlay {
    EncodedImage image;
    Rect area;          ///< canvas units
    float opacity = 0.5f;
    bool visible = true;
};
bool operator==(const Underlay &a, const Underlay &b);

/// The painting: an immutable value once it is shared. Strokes stand from bottom to top.
struct Painting {
    Canvas canvas;
    StrokeList strokes;
    std::vector<Group> groups;
    std::vector<Swatch> swatches;
    std::shared_ptr<const Underlay> underlay;

    /// Null where there is none.
    StrokePtr find(StrokeId id) const;
    /// Position in the order, or -1.
    int indexOf(StrokeId id) const;
    /// Visible itself and in visible groups only.
    bool isVisible(const Stroke &stroke) const;
    bool isLocked(const Stroke &stroke) const;
    std::size_t segmentCount() const;
    /// The moment when all has dried: the default document time.
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
