#include "model/formats/messages.h"
#include "model/formats/suffuse/fill_columns.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_predict.h"
#include "model/formats/suffuse/suffuse_strokes.h"

#include <numeric>

namespace suffuse {

namespace {

/// Turns integers into values. What the values mean is checked afterwards by validate.h.
class StrokesReader {
public:
    explicit StrokesReader(QByteArrayView payload) : m_in(payload) {}

    QString read(Allowance &allowance, std::vector<StrokePtr> &strokes)
    {
        const std::size_t n = m_in.getU32(), m = m_in.getU32();
        if (!m_in.ok() || n > m || !allowance.takeSegments(m))
            return FileMessages::tr("%1 strokes and %2 segments are more than the file can hold").arg(n).arg(m);
        const auto mayUnpack = [&](std::uint64_t bytes) { return allowance.takeBlock(bytes); };
        if (!readPalettes(m_in.getBlock(mayUnpack), n, m) || !readStrokeColumns(n, m) ||
            !readSegmentColumns(n, m, allowance))
            return FileMessages::tr("its columns are not what the format allows");
        strokes.reserve(strokes.size() + n);
        for (std::size_t j = 0; j < n; ++j) {
            auto stroke = std::make_shared<Stroke>();
            if (!decode(j, *stroke))
                return FileMessages::tr("stroke %1 of it is not what the format allows").arg(j);
            strokes.push_back(std::move(stroke));
        }
        return {};
    }

private:
    /// Reads the palettes. A palette must not have more entries than users.
    bool readPalettes(const QByteArray &bytes, std::size_t n, std::size_t m)
    {
        ByteCursor in(bytes);
        for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left) {
            const QByteArrayView text = in.take(in.varint());
            if (!in.ok() || m_texts.size() >= 3 * n)
                return false;
            m_texts.push_back(QString::fromUtf8(text));
        }
        for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left) {
            Style style;
            const std::uint32_t kind = in.u32();
            for (float &xi : style.xi)
                xi = std::bit_cast<float>(in.u32());
            style.kind = StyleKind(kind);
            if (!in.ok() || kind >= WordsOf<StyleKind>::list.size() || m_styles.size() >= n + m)
                return false;
            m_styles.push_back(style);
        }
        for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left) {
            const std::uint32_t mode = in.u32();
            const float beta = std::bit_cast<float>(in.u32());
            if (!in.ok() || mode >= WordsOf<MixMode>::list.size() || m_mixes.size() >= n)
                return false;
            m_mixes.push_back({MixMode(mode), beta});
        }
        return in.ok() && in.left() == 0;
    }

    bool readStrokeColumns(std::size_t n, std::size_t m)
    {
        m_id = m_in.get<std::uint64_t>(n);
        m_count = m_in.get<std::uint32_t>(n);
        m_flags = m_in.get<std::uint8_t>(n);
        m_name = m_in.get<std::uint32_t>(n);
        m_brush = m_in.get<std::uint32_t>(n);
        m_group = m_in.get<std::uint64_t>(n);
        m_style = m_in.get<std::uint32_t>(n);
        m_mix = m_in.get<std::uint32_t>(n);
        for (auto &axis : m_origin)
            axis = m_in.get<std::uint64_t>(n);
        for (auto &modes : m_modes)
            modes = m_in.get<std::uint8_t>(n);
        return m_in.ok() && std::accumulate(m_count.begin(), m_count.end(), std::uint64_t(0)) == m;
    }

    bool readSegmentColumns(std::size_t n, std::size_t m, Allowance &allowance)
    {
        for (auto &axis : m_node)
            axis = m_in.get<std::uint32_t>(m + n);
        for (auto &axis : m_handle) {
            for (auto &handle : axis)
                handle = m_in.get<std::uint32_t>(m);
        }
        for (auto &attribute : m_attribute)
            attribute = m_in.get<std::uint32_t>(m);
        m_born = m_in.get<std::uint64_t>(m);
        m_ownStyle = m_in.get<std::uint32_t>(m);
        m_nodeKind = m_in.get<std::uint8_t>(m);
        m_plain.get(m_in, m);
        m_rewetCount = m_in.get<std::uint32_t>(m);
        const std::uint64_t rewets = std::accumulate(m_rewetCount.begin(), m_rewetCount.end(), std::uint64_t(0));
        if (!m_in.ok() || !allowance.takeRewets(rewets))
            return false;
        m_rewetTime = m_in.get<std::uint64_t>(rewets);
        m_rewetExtra = m_in.get<std::uint64_t>(rewets);
        if (!m_in.atEnd()) {
            m_marks.get(m_in, m);
            const std::size_t starts = m_marks.count(&Segment::start);
            for (auto &axis : m_start)
                axis = m_in.get<std::uint32_t>(starts);
        }
        if (!m_in.atEnd() && !m_fills.get(m_in, n))
            return false;
        if (!m_in.atEnd() && !m_pictures.get(m_in, n))
            return false;
        m_later.getUsed(m_in, m);
        return m_in.atEnd();
    }

    bool decode(std::size_t j, Stroke &stroke)
    {
        const std::size_t count = m_count[j];
        for (const auto &modes : m_modes) {
            if (modes[j] > ColumnMode::largestByte)
                return false;
        }
        if (count == 0 || m_flags[j] > 3 || m_name[j] >= m_texts.size() || m_brush[j] >= m_texts.size() ||
            m_style[j] >= m_styles.size() || m_mix[j] >= m_mixes.size())
            return false;
        m_idBefore += m_id[j] + 1;
        stroke.id = m_idBefore;
        stroke.name = m_texts[m_name[j]];
        stroke.brush = m_texts[m_brush[j]];
        stroke.group = m_group[j];
        stroke.visible = m_flags[j] & 1;
        stroke.locked = m_flags[j] & 2;
        stroke.style = m_styles[m_style[j]];
        stroke.mix = m_mixes[m_mix[j]];
        stroke.origin = {std::bit_cast<double>(m_origin[0][j]), std::bit_cast<double>(m_origin[1][j])};
        StrokeColumns c;
        c.resize(count);
        decodeColumns(j, c);
        stroke.segments.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            if (!decodeSegment(c, k, stroke.segments[k]))
                return false;
        }
        m_fills.set(stroke, j);
        if (!m_pictures.set(stroke, j, m_texts))
            return false;
        m_segment += count;
        m_nodes += count + 1;
        return true;
    }

    void decodeColumns(std::size_t j, StrokeColumns &c)
    {
        const auto value = [](std::uint32_t code, double prediction, int digits) {
            return dequantised(std::int32_t(std::uint32_t(quantised(prediction, digits)) + unzigzag(code)), digits);
        };
        for (std::size_t k = 0; k < c.born.size(); ++k) {
            m_bornStep += unzigzag64(m_born[m_segment + k]);
            m_bornBefore += m_bornStep;
            c.born[k] = Microseconds(m_bornBefore);
        }
        const ColumnMode nodes = ColumnMode::fromByte(m_modes[0][j]), handles = ColumnMode::fromByte(m_modes[1][j]);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::uint32_t *code = m_node[axis].data() + m_nodes;
            walkSeries(c.node[axis], 0, nodes.predictor,
                       [&](float &v, double prediction) { v = value(*code++, prediction, nodes.digits); });
        }
        if (!m_start[0].empty())
            decodeStarts(c, [&](std::uint32_t code, double before) { return value(code, before, nodes.digits); });
        for (std::size_t axis = 0; axis < 2; ++axis) {
            std::size_t place = 0;
            walkHandles(c, axis, c.born.size(), handles.predictor, [&](float &v, double prediction) {
                v = value(m_handle[axis][place & 1][m_segment + place / 2], prediction, handles.digits);
                ++place;
            });
        }
        for (std::size_t a = 0; a < StrokeColumns::attributeCount; ++a) {
            const ColumnMode mode = ColumnMode::fromByte(m_modes[2 + a][j]);
            const std::uint32_t *code = m_attribute[a].data() + m_segment;
            walkSeries(c.attribute[a], m_carry[a], mode.predictor,
                       [&](float &v, double prediction) { v = value(*code++, prediction, mode.digits); });
            m_carry[a] = c.attribute[a].back();
        }
    }

    /// Decodes where segments begin that need not begin where the one before them ends, by `value(code, prediction)`.
    template <typename Value>
    void decodeStarts(StrokeColumns &c, Value value)
    {
        const std::size_t count = c.born.size();
        c.starts.resize(count);
        for (auto &axis : c.startsAt)
            axis.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            c.starts[k] = m_marks.has(&Segment::start, m_segment + k);
            if (!c.starts[k])
                continue;
            for (std::size_t axis = 0; axis < 2; ++axis)
                c.startsAt[axis][k] = value(m_start[axis][m_startPlace], double(c.node[axis][k]));
            ++m_startPlace;
        }
    }

    bool decodeSegment(const StrokeColumns &c, std::size_t k, Segment &s)
    {
        s.bezier = {Offset{c.beginOf(0, k), c.beginOf(1, k)}, Offset{c.handle[0][0][k], c.handle[0][1][k]},
                    Offset{c.handle[1][0][k], c.handle[1][1][k]}, Offset{c.node[0][k + 1], c.node[1][k + 1]}};
        for (std::size_t a = 0; a < StrokeColumns::attributeCount; ++a)
            predictedNumbersOf<Segment>[a].of(s) = c.attribute[a][k];
        s.born = c.born[k];
        const std::size_t at = m_segment + k;
        if (m_ownStyle[at] > m_styles.size() || m_nodeKind[at] >= WordsOf<NodeKind>::list.size())
            return false;
        if (m_ownStyle[at] > 0)
            s.style = m_styles[m_ownStyle[at] - 1];
        s.node = NodeKind(m_nodeKind[at]);
        m_plain.set(s, at);
        m_later.set(s, at);
        if (!m_marks.set(s, at))
            return false;
        s.rewet.reserve(m_rewetCount[at]);
        for (std::uint32_t r = 0; r < m_rewetCount[at]; ++r, ++m_rewet) {
            const std::uint64_t time = std::uint64_t(s.born) + unzigzag64(m_rewetTime[m_rewet]);
            s.rewet.push_back({Microseconds(time), Microseconds(m_rewetExtra[m_rewet])});
        }
        return true;
    }

    ColumnReader m_in;
    std::vector<QString> m_texts;
    std::vector<Style> m_styles;
    std::vector<Mix> m_mixes;
    std::vector<std::uint64_t> m_id, m_group;
    std::array<std::vector<std::uint64_t>, 2> m_origin;
    std::vector<std::uint32_t> m_count, m_name, m_brush, m_style, m_mix;
    std::vector<std::uint8_t> m_flags, m_nodeKind;
    std::array<std::vector<std::uint8_t>, 2 + StrokeColumns::attributeCount> m_modes;
    std::array<std::vector<std::uint32_t>, 2> m_node;
    std::array<std::array<std::vector<std::uint32_t>, 2>, 2> m_handle;
    std::array<std::vector<std::uint32_t>, StrokeColumns::attributeCount> m_attribute;
    PlainColumns<Segment> m_plain;
    FlagColumn<Segment> m_marks;
    FillColumns m_fills;
    PictureColumns m_pictures;
    std::array<std::vector<std::uint32_t>, 2> m_start;
    LaterColumns<Segment> m_later;
    std::vector<std::uint32_t> m_ownStyle, m_rewetCount;
    std::vector<std::uint64_t> m_born, m_rewetTime, m_rewetExtra;
    std::array<float, StrokeColumns::attributeCount> m_carry{};
    std::uint64_t m_idBefore = 0, m_bornBefore = 0, m_bornStep = 0;
    std::size_t m_segment = 0, m_nodes = 0, m_rewet = 0, m_startPlace = 0; ///< places in the columns
};

} // namespace

QString readStrokes(QByteArrayView payload, Allowance &allowance, std::vector<StrokePtr> &strokes)
{
    return StrokesReader(payload).read(allowance, strokes);
}

} // namespace suffuse
