#include "app/python/views.h"

namespace suffuse::python {

namespace {

/// The command line that asks for the same: so the same is understood, and refused in the same words.
class Asked {
public:
    Asked()
    {
        for (const char *option : {"size", "scale", "area", "time", "backend", "threads", "devices"})
            m_line.add({QLatin1String(option)}, {}, QStringLiteral("VALUE"));
    }
    void set(const char *option, const QString &value)
    {
        m_arguments.append(QStringLiteral("--%1=%2").arg(QLatin1String(option), value));
    }
    void set(const char *option, double value) { set(option, text(value)); }
    const cli::CommandLine &line()
    {
        if (m_line.parse(m_arguments))
            raise(Raised::Plain, QStringLiteral("the options could not be understood"));
        return m_line;
    }
    /// The shortest text that reads back to the same number.
    static QString text(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

private:
    cli::CommandLine m_line{QStringLiteral("render"), {}, {}};
    QStringList m_arguments{QStringLiteral("suffuse"), QStringLiteral("render")};
};

QString sizeText(const py::object &size)
{
    const auto number = [](const py::handle &value) { return py::str(value).cast<QString>(); };
    if (!py::isinstance<py::sequence>(size) || py::isinstance<py::str>(size))
        return number(size);
    QStringList parts;
    for (const py::handle value : size)
        parts.append(number(value));
    return parts.join(QLatin1Char('x'));
}

} // namespace

cli::PictureOptions pictureOptionsOf(const ViewWish &wish, const Painting &painting)
{
    Asked asked;
    if (!wish.size.is_none())
        asked.set("size", sizeText(wish.size));
    if (wish.scale)
        asked.set("scale", *wish.scale);
    if (wish.area) {
        QStringList parts;
        for (const double v : *wish.area)
            parts.append(Asked::text(v));
        asked.set("area", parts.join(QLatin1Char(',')));
    }
    if (wish.time)
        asked.set("time", *wish.time);
    return valueOf(cli::pictureOptions(asked.line(), painting), Raised::Value);
}

Microseconds momentOf(std::optional<double> time, const Painting &painting)
{
    Asked asked;
    if (time)
        asked.set("time", *time);
    return valueOf(cli::timeOption(asked.line(), painting), Raised::Value);
}

RendererOptions rendererOptionsOf(const QString &backend, int threads, const py::object &devices)
{
    Asked asked;
    asked.set("backend", backend);
    if (threads != 0)
        asked.set("threads", QString::number(threads));
    if (!devices.is_none())
        asked.set("devices", py::str(devices).cast<QString>());
    return valueOf(cli::rendererOptions(asked.line()), Raised::Value);
}

} // namespace suffuse::python
