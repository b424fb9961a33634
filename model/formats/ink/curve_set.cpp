#include "model/formats/ink/curve_set.h"

#include "model/formats/messages.h"

#include <QXmlStreamReader>

#include <cmath>

namespace suffuse {

namespace {

constexpr qint64 largestXml = qint64(64) << 20;

class CurveReader {
public:
    explicit CurveReader(const QByteArray &bytes) : m_xml(bytes) {}

    Result<CurveSet> read()
    {
        if (!m_xml.readNextStartElement() || m_xml.name() != QLatin1String("curve_set"))
            fail(FileMessages::tr("the first element is not curve_set"));
        m_picture.width = number("image_width");
        m_picture.height = number("image_height");
        while (m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("curve"))
                curve();
            else
                m_xml.skipCurrentElement();
        }
        if (m_xml.hasError())
            return Error{FileMessages::tr("line %1: %2").arg(m_xml.lineNumber()).arg(m_xml.errorString())};
        return std::move(m_picture);
    }

private:
    void fail(const QString &what)
    {
        if (!m_xml.hasError())
            m_xml.raiseError(what);
    }

    /// An attribute of the current element as a finite number.
    double number(const char *name)
    {
        const auto text = m_xml.attributes().value(QLatin1String(name));
        bool ok = false;
        const double value = text.toDouble(&ok);
        if (!ok || !(std::abs(value) <= 1e6))
            fail(FileMessages::tr("%1 of %2 is \"%3\", not a number up to 1e6")
                     .arg(QLatin1String(name), m_xml.name().toString(), text.left(40).toString()));
        return ok ? value : 0;
    }

    /// The colour of the current element. Colours are written in the order of OpenCV's images, so what is called R is
    /// blue.
    CurveColour colour()
    {
        CurveColour rgb{number("B"), number("G"), number("R")};
        for (double &channel : rgb)
            channel = std::clamp(channel / 255, 0.0, 1.0);
        return rgb;
    }

    void curve()
    {
        DiffusionCurve curve;
        while (m_xml.readNextStartElement()) {
            while (m_xml.readNextStartElement()) {
                const auto name = m_xml.name();
                if (name == QLatin1String("control_point")) // Rows come first.
                    curve.points.push_back({number("y"), number("x")});
                else if (name == QLatin1String("left_color"))
                    curve.left.add(number("globalID"), colour());
                else if (name == QLatin1String("right_color"))
                    curve.right.add(number("globalID"), colour());
                else if (name == QLatin1String("best_scale") || name == QLatin1String("blur_point"))
                    curve.blur.add(number("globalID"), std::max(0.0, number("value")));
                m_xml.skipCurrentElement();
            }
        }
        if (m_xml.hasError())
            return;
        if (curve.points.size() < 4 || curve.points.size() % 3 != 1)
            return fail(FileMessages::tr("a curve has %1 control points; 3n + 1 make cubics").arg(curve.points.size()));
        if (curve.left.empty() || curve.right.empty())
            return fail(FileMessages::tr("a curve has no colours on one of its sides"));
        curve.left.sort();
        curve.right.sort();
        curve.blur.sort();
        m_picture.curves.push_back(std::move(curve));
    }

    QXmlStreamReader m_xml;
    CurveSet m_picture;
};

} // namespace

Result<CurveSet> readCurveSet(const QByteArray &bytes, const QString &fileName)
{
    if (bytes.size() > largestXml)
        return fileError(fileName, FileMessages::tr("has more than 64 MB of XML; that is more than is read"));
    Result<CurveSet> read = CurveReader(bytes).read();
    return read ? read : Result<CurveSet>(fileError(fileName, read.error()));
}

} // namespace suffuse
