#include "app/window/layout/window_layout.h"

#include "app/session/settings/settings.h"
#include "app/widgets/habits/place_beside.h"

#include <QDataStream>
#include <QIODevice>
#include <QMainWindow>
#include <QTimer>

#include <zlib.h>

namespace suffuse::window_layout {

namespace {

constexpr int layoutVersion = 1;
constexpr int maxLayoutBytes = 1 << 20;

/// CRC-32 (IEEE 802.3) in hexadecimal digits.
QString checksum(const QByteArray &bytes)
{
    return QString::number(crc32(0, reinterpret_cast<const Bytef *>(bytes.constData()), uInt(bytes.size())), 16);
}

struct Layout {
    QByteArray geometry;
    QByteArray state;
    bool isMaximised = false; ///< told beside the geometry, which Qt does not restore on a screen of another size
};

QByteArray pack(const Layout &layout)
{
    QByteArray body;
    QDataStream out(&body, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_4);
    out << layout.geometry << layout.state << layout.isMaximised;
    return body;
}

/// Empty state where the stored bytes are not exactly what was saved.
Layout readLayout()
{
    QSettings &s = settings::store();
    const QByteArray body = QByteArray::fromBase64(s.value("layout/bytes").toString().toLatin1());
    Layout layout;
    if (s.value("layout/version").toInt() != layoutVersion || body.isEmpty() || body.size() > maxLayoutBytes ||
        s.value("layout/crc").toString() != checksum(body))
        return layout;
    QDataStream in(body);
    in.setVersion(QDataStream::Qt_6_4);
    in >> layout.geometry >> layout.state;
    if (!in.atEnd()) // layouts of earlier versions end here
        in >> layout.isMaximised;
    return in.status() == QDataStream::Ok ? layout : Layout{};
}

/// Clears the "starting" flag at the first idle moment with the window shown.
void watchStart(QMainWindow &window)
{
    auto *timer = new QTimer(&window);
    timer->setInterval(300);
    QObject::connect(timer, &QTimer::timeout, &window, [timer, &window] {
        if (!window.isVisible())
            return;
        settings::store().remove("layout/starting");
        settings::store().sync();
        timer->deleteLater();
    });
    timer->start();
}

/// Puts a stored layout back, if there is one that has not made the last start fail.
bool restoreStored(QMainWindow &window)
{
    const bool lastStartFailed = settings::store().value("layout/starting").toBool();
    if (lastStartFailed) {
        reset();
        return false;
    }
    const Layout layout = readLayout();
    if (layout.state.isEmpty())
        return false;
    settings::store().setValue("layout/starting", true);
    settings::store().sync();
    if (!window.restoreGeometry(layout.geometry) && layout.isMaximised)
        window.setWindowState(window.windowState() | Qt::WindowMaximized);
    const bool restored = window.restoreState(layout.state, layoutVersion);
    watchStart(window);
    return restored;
}

} // namespace

void save(const QMainWindow &window)
{
    const QByteArray body = pack({window.saveGeometry(), window.saveState(layoutVersion), window.isMaximized()});
    QSettings &s = settings::store();
    s.setValue("layout/version", layoutVersion);
    s.setValue("layout/crc", checksum(body));
    s.setValue("layout/bytes", QString::fromLatin1(body.toBase64()));
    s.remove("layout/starting");
    s.sync();
}

bool restore(QMainWindow &window)
{
    const bool restored = restoreStored(window);
    keepOnScreen(window); // the screen may be another one, or the usual size too large for it
    return restored;
}

QString sealed(const QMainWindow &window)
{
    const QByteArray state = window.saveState(layoutVersion);
    return checksum(state) + ' ' + QString::fromLatin1(state.toBase64());
}

bool restoreSealed(QMainWindow &window, const QString &text)
{
    const QByteArray state = QByteArray::fromBase64(text.section(' ', 1).toLatin1());
    return !state.isEmpty() && state.size() <= maxLayoutBytes && text.section(' ', 0, 0) == checksum(state) &&
           window.restoreState(state, layoutVersion);
}

void reset()
{
    settings::store().remove("layout");
    settings::store().sync();
}

bool isStored()
{
    return !readLayout().state.isEmpty();
}

} // namespace suffuse::window_layout
