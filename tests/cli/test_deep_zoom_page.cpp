// The page that shows a Deep Zoom, in a headless browser: what it shows, and what wheel, fingers and keys do.
#include "cli_pictures.h"

#include "tests/files.h"

#include <QStandardPaths>

using namespace suffuse;

namespace {

QString browser()
{
    for (const char *name : {"chromium", "chromium-browser", "google-chrome"})
        if (const QString path = QStandardPaths::findExecutable(name); !path.isEmpty())
            return path;
    return {};
}

/// What is in a page at the end, as text.
QByteArray browse(const QTemporaryDir &folder, const QString &page)
{
    QProcess process;
    process.start(browser(), QStringList{"--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                                         "--hide-scrollbars", "--no-first-run", "--force-color-profile=srgb",
                                         "--user-data-dir=" + folder.filePath("browser"), "--window-size=700,600",
                                         "--allow-file-access-from-files", "--virtual-time-budget=4000", "--dump-dom",
                                         "file://" + page});
    if (!process.waitForFinished(120'000)) {
        process.kill();
        process.waitForFinished();
    }
    return process.readAllStandardOutput();
}

/// Leaves what the canvas shows in the page, when all tiles have come.
constexpr char shot[] = R"html(
<script>
const shoot = () => {
  if (document.body.dataset.whole === "true")
    document.body.dataset.shot = canvas.toDataURL();
  else
    setTimeout(shoot, 50);
};
shoot();
</script>
</body>)html";

/// Does to the page what a person would do, and leaves what came of it in the page.
constexpr char script[] = R"html(
<script>
const close = (a, b) => Math.abs(a - b) < 1e-6 * Math.max(1, Math.abs(a), Math.abs(b));
const under = (x, y) => [view.x + x / view.scale, view.y + y / view.scale];
const results = {};
const canvas_ = document.querySelector("canvas");
const send = (type, name, x, y, more) => canvas_.dispatchEvent(
  new type(name, Object.assign({ clientX: x, clientY: y, bubbles: true, cancelable: true }, more)));
canvas_.setPointerCapture = () => {};
const key = name => dispatchEvent(new KeyboardEvent("keydown", { key: name, cancelable: true }));
results.fits = close(view.scale, 1) && close(view.x, -50) && close(view.y, -50);
let before = under(90, 120);
send(WheelEvent, "wheel", 90, 120, { deltaY: -480 });
results.wheel = close(view.scale, 4) && close(under(90, 120)[0], before[0]) && close(under(90, 120)[1], before[1]);
before = view.x;
send(PointerEvent, "pointerdown", 100, 100, { pointerId: 1 });
send(PointerEvent, "pointermove", 60, 100, { pointerId: 1 });
results.pan = close(view.x, before + 10);
before = under(100, 100);
send(PointerEvent, "pointerdown", 140, 100, { pointerId: 2 });
send(PointerEvent, "pointermove", 220, 100, { pointerId: 2 });
results.pinch = close(view.scale, 8) && close(under(140, 100)[0], before[0]);
send(PointerEvent, "pointerup", 60, 100, { pointerId: 1 });
send(PointerEvent, "pointerup", 220, 100, { pointerId: 2 });
key("1");
results.pixels = close(view.scale, 1);
before = view.x;
key("ArrowRight");
results.arrow = view.x > before;
key("+");
results.plus = close(view.scale, 2);
key("-");
key("0");
results.all = close(view.scale, 1) && close(view.x, -50) && close(view.y, -50);
for (let i = 0; i < 40; ++i)
  send(WheelEvent, "wheel", 0, 0, { deltaY: -2000 });
results.nearest = close(view.scale, 64);
for (let i = 0; i < 40; ++i)
  send(WheelEvent, "wheel", 0, 0, { deltaY: 2000 });
results.farthest = close(view.scale, 0.5);
document.body.dataset.results = Object.entries(results).map(([name, good]) => name + "=" + good).join(" ");
</script>
</body>)html";

} // namespace

class TestDeepZoomPage : public CliPictures {
    Q_OBJECT

    /// The page with a canvas of 400 × 325 pixels, whatever room the browser's window leaves.
    QByteArray page() const
    {
        return bytesOf(path("a.html"))
            .replace("</style>", "canvas { width: 400px !important; height: 325px !important; }</style>");
    }

    /// What a script left in a page. A browser on a busy machine may end before it, and is started again.
    QByteArray leftIn(const QString &page, const QByteArray &name) const
    {
        const QByteArray begin = "data-" + name + "=\"";
        for (int attempt = 0; attempt < 20; ++attempt) {
            const QByteArray dom = browse(m_folder, path(page));
            if (const qsizetype at = dom.indexOf(begin); at > 0)
                return dom.mid(at + begin.size(), dom.indexOf('"', at + begin.size()) - at - begin.size());
        }
        return {};
    }

private slots:
    void initTestCase()
    {
        if (browser().isEmpty())
            QSKIP("no Chromium is installed (apt-get install chromium)");
        prepare();
        const CliOutcome drawn = runCli({"render", path("a.json"), "--tiles", path("a.dzi"), "--size", "300x225",
                                         "--tile", "64", "--format", "png"});
        QVERIFY2(drawn.code == 0, qPrintable(drawn.text()));
    }

    /// At first all of the picture is shown, here pixel by pixel.
    void shows()
    {
        QVERIFY(put(path("shows.html"), page().replace("</body>", shot)));
        const QByteArray url = leftIn("shows.html", "shot");
        const Result<FloatPicture> screen = readImage(QByteArray::fromBase64(url.mid(url.indexOf(',') + 1)), "screen");
        const FloatPicture whole = rendered({"--size", "300x225"}, "whole.png");
        QVERIFY2(screen && screen->width == 400 && screen->height == 325, url.left(100).constData());
        int off = 0;
        for (int y = 0; y < 225; ++y)
            for (int i = 0; i < 300 * 4; ++i)
                off += std::abs(screen->at(50, 50 + y)[i] - whole.at(0, y)[i]) > 2.0f / 255;
        QCOMPARE(off, 0);
        QVERIFY(std::abs(screen->at(10, 10)[0] - 128.0f / 255) < 2.0f / 255);
    }

    void hands()
    {
        QVERIFY(put(path("hands.html"), page().replace("</body>", script)));
        const QByteArray results = leftIn("hands.html", "results");
        for (const char *name :
             {"fits", "wheel", "pan", "pinch", "pixels", "arrow", "plus", "all", "nearest", "farthest"})
            QVERIFY2((' ' + results + ' ').contains(QByteArray(" ") + name + "=true "), results.constData());
    }
};

QTEST_GUILESS_MAIN(TestDeepZoomPage)
#include "test_deep_zoom_page.moc"
