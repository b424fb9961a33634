// The pictures of a stroke chunk as columns of a document (docs/file-format.md), and the images that they show.
#pragma once

#include "model/formats/suffuse/field_columns.h"

#include <functional>
#include <map>
#include <span>

namespace suffuse {

/// One column says which strokes have a picture, and whether it is linked; the others have a number for each picture.
/// The images are named by their SHA-256, so a chunk stands alone.
class PictureColumns {
public:
    /// `placeOf` gives the place of a link among the texts of the chunk.
    void add(const Stroke &stroke, const std::function<std::uint32_t(const QString &)> &placeOf);
    bool isUsed() const { return !m_width.empty(); }
    void put(ColumnWriter &out) const;

    /// Reads the columns of so many strokes. Returns false if they are not what the format allows.
    bool get(ColumnReader &in, std::size_t strokes);
    /// Gives a stroke the picture at its place among the strokes, without its image. The strokes come in order. Returns
    /// false if its link is not among the texts.
    bool set(Stroke &stroke, std::size_t place, const std::vector<QString> &texts);

private:
    enum Mark : std::uint8_t { None, Embedded, Linked };
    using Words = std::vector<std::uint32_t>;

    std::vector<std::uint8_t> m_marks; ///< by stroke
    Words m_width, m_height;
    std::array<Words, 6> m_corners;                   ///< bits of x and y of corner, right and down
    std::array<std::vector<std::uint64_t>, 4> m_hash; ///< the SHA-256, eight bytes each, the first ones lowest
    Words m_link;
    std::size_t m_picture = 0, m_linked = 0; ///< places in the columns that are read next
};

/// Images by their SHA-256, which is computed only once one is looked for.
class ImagesByHash {
public:
    void add(EncodedImage image);
    /// Adds the image of a stroke's picture, if it has one.
    void addOf(const Stroke &stroke);
    /// Gives the strokes whose pictures are in the painting their images, as far as they are known. Returns how many
    /// are missing.
    std::size_t giveTo(std::span<StrokePtr> strokes);

private:
    EncodedImage find(const QString &sha256);

    std::vector<EncodedImage> m_unknown; ///< whose hashes are not computed yet
    std::map<QString, EncodedImage> m_known;
};

/// The images that the strokes' pictures have in the painting, each once.
std::vector<EncodedImage> imagesOf(std::span<const StrokePtr> strokes);
/// Appends images that are not in a list yet, by their bytes.
void appendNew(std::vector<EncodedImage> &images, const std::vector<EncodedImage> &others);

} // namespace suffuse
