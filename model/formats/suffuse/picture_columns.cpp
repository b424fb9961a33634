#include "model/formats/suffuse/picture_columns.h"

#include <algorithm>
#include <set>

namespace suffuse {

namespace {

constexpr std::array corners{&Picture::corner, &Picture::right, &Picture::down};

} // namespace

void PictureColumns::add(const Stroke &stroke, const std::function<std::uint32_t(const QString &)> &placeOf)
{
    m_marks.push_back(!stroke.picture ? None : stroke.picture->isLinked() ? Linked : Embedded);
    if (!stroke.picture)
        return;
    const Picture &picture = *stroke.picture;
    m_width.push_back(picture.width);
    m_height.push_back(picture.height);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Offset place = picture.*corners[k];
        m_corners[2 * k].push_back(std::bit_cast<std::uint32_t>(place.x));
        m_corners[2 * k + 1].push_back(std::bit_cast<std::uint32_t>(place.y));
    }
    const QByteArray hash = QByteArray::fromHex(picture.sha256.toLatin1()).leftJustified(32, 0, true);
    for (std::size_t k = 0; k < 32; ++k) {
        if (k % 8 == 0)
            m_hash[k / 8].push_back(0);
        m_hash[k / 8].back() |= std::uint64_t(std::uint8_t(hash[qsizetype(k)])) << (8 * (k % 8));
    }
    if (picture.isLinked())
        m_link.push_back(placeOf(picture.link));
}

void PictureColumns::put(ColumnWriter &out) const
{
    out.put(m_marks);
    out.put(m_width);
    out.put(m_height);
    for (const Words &column : m_corners)
        out.put(column);
    for (const auto &column : m_hash)
        out.put(column);
    out.put(m_link);
}

bool PictureColumns::get(ColumnReader &in, std::size_t strokes)
{
    m_marks = in.get<std::uint8_t>(strokes);
    if (std::ranges::any_of(m_marks, [](std::uint8_t mark) { return mark > Linked; }))
        return false;
    const auto linked = std::size_t(std::ranges::count(m_marks, std::uint8_t(Linked)));
    const std::size_t count = linked + std::size_t(std::ranges::count(m_marks, std::uint8_t(Embedded)));
    m_width = in.get<std::uint32_t>(count);
    m_height = in.get<std::uint32_t>(count);
    for (Words &column : m_corners)
        column = in.get<std::uint32_t>(count);
    for (auto &column : m_hash)
        column = in.get<std::uint64_t>(count);
    m_link = in.get<std::uint32_t>(linked);
    return in.ok();
}

bool PictureColumns::set(Stroke &stroke, std::size_t place, const std::vector<QString> &texts)
{
    if (m_marks.empty() || m_marks[place] == None)
        return true;
    const std::size_t at = m_picture++;
    Picture picture;
    picture.width = m_width[at];
    picture.height = m_height[at];
    for (std::size_t k = 0; k < corners.size(); ++k)
        picture.*
            corners[k] = {std::bit_cast<float>(m_corners[2 * k][at]), std::bit_cast<float>(m_corners[2 * k + 1][at])};
    QByteArray hash(32, 0);
    for (std::size_t k = 0; k < 32; ++k)
        hash[qsizetype(k)] = char(m_hash[k / 8][at] >> (8 * (k % 8)) & 255);
    picture.sha256 = QString::fromLatin1(hash.toHex());
    if (m_marks[place] == Linked) {
        const std::size_t link = m_link[m_linked++];
        if (link >= texts.size() || texts[link].isEmpty())
            return false;
        picture.link = texts[link];
    }
    stroke.picture = std::move(picture);
    return true;
}

void ImagesByHash::add(EncodedImage image)
{
    if (image)
        m_unknown.push_back(std::move(image));
}

void ImagesByHash::addOf(const Stroke &stroke)
{
    if (stroke.picture && stroke.picture->image)
        m_known.emplace(stroke.picture->sha256, stroke.picture->image);
}

EncodedImage ImagesByHash::find(const QString &sha256)
{
    for (auto known = m_known.find(sha256);; known = m_known.find(sha256)) {
        if (known != m_known.end())
            return known->second;
        if (m_unknown.empty())
            return {};
        m_known.emplace(sha256Of(*m_unknown.back()), m_unknown.back());
        m_unknown.pop_back();
    }
}

std::size_t ImagesByHash::giveTo(std::span<StrokePtr> strokes)
{
    std::size_t missing = 0;
    for (StrokePtr &stroke : strokes) {
        if (!stroke->picture || stroke->picture->isLinked() || stroke->picture->image)
            continue;
        Picture picture = *stroke->picture;
        picture.image = find(picture.sha256);
        if (!picture.image) {
            ++missing;
            continue;
        }
        auto whole = std::make_shared<Stroke>(*stroke);
        whole->picture = std::move(picture);
        stroke = std::move(whole);
    }
    return missing;
}

std::vector<EncodedImage> imagesOf(std::span<const StrokePtr> strokes)
{
    std::vector<EncodedImage> images;
    std::set<QString> seen;
    for (const StrokePtr &stroke : strokes)
        if (stroke->picture && !stroke->picture->isLinked() && stroke->picture->image &&
            seen.insert(stroke->picture->sha256).second)
            images.push_back(stroke->picture->image);
    return images;
}

void appendNew(std::vector<EncodedImage> &images, const std::vector<EncodedImage> &others)
{
    for (const EncodedImage &image : others)
        if (std::ranges::none_of(images, [&](const EncodedImage &i) { return i == image || *i == *image; }))
            images.push_back(image);
}

} // namespace suffuse
