// Pictures in tiles: each tile is a crop of the whole picture, to the bit; what is there and whole is kept.
#include "render/tiles/big_tiff.h"
#include "render/tiles/render_tiles.h"
#include "tests/files.h"
#include "tests/render/paintings.h"

#include <QDir>
#include <QTemporaryDir>

#include <tiffio.h>

using namespace suffuse;
using namespace suffuse::test;

namespace {

PaintingPtr somePainting(PaperKind paper = PaperKind::Procedural)
{
    std::mt19937_64 random(7);
    Paper p;
    p.kind = paper;
    return painting(randomStrokes(random, 12, 96, 72), 96, 72, p);
}

std::unique_ptr<Renderer> cpu(int threads = 2)
{
    return std::move(*makeRenderer({.backend = Backend::Cpu, .threads = threads}));
}

/// The whole picture of a level, drawn at once.
FloatPicture wholeOf(const PaintingPtr &painting, const View &view, bool transparent)
{
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = view;
    request.transparent = transparent;
    FloatPicture out;
    if (!cpu()->render(request, out))
        qFatal("no picture");
    return out;
}

TiledPicture tiledPicture(const QString &path, const View &view, TileOptions options, TileFormat format, int bits,
                          bool alpha)
{
    TileEncoding encoding;
    encoding.format = format;
    encoding.side = options.tile;
    encoding.image.alpha = alpha;
    encoding.image.depth = bits == 16 ? ImageDepth::Bits16 : ImageDepth::Bits8;
    return {{view, options}, encoding, path, "picture"};
}

Result<TilesStats> draw(const PaintingPtr &painting, const TiledPicture &picture, TileStore &store, int threads = 2)
{
    TilesRequest request;
    request.picture.painting = painting;
    request.picture.time = painting->end();
    request.picture.transparent = picture.encoding.image.alpha;
    request.threads = threads;
    request.count = picture.plan.sheets();
    request.sheet = [](qint64 i) { return i; };
    std::vector<std::unique_ptr<Renderer>> renderers;
    renderers.push_back(cpu(threads));
    return renderTiles(renderers, request, picture, store);
}

/// Draws as `render --tiles` does; what it drew.
Result<TilesStats> drawDeepZoom(const PaintingPtr &painting, const TiledPicture &picture, int threads = 2)
{
    const QString files = DeepZoomStore::filesOf(picture.path), path = files + "/tiles.journal";
    QDir().mkpath(files);
    const auto read = TileJournal::read(path, picture.identity);
    if (!read)
        return Error{read.error()};
    SheetRecords records;
    for (const SheetRecord &record : *read)
        records.emplace(record.sheet, record);
    TileJournal journal;
    if (const Result<void> opened = journal.open(path, picture.identity); !opened)
        return Error{opened.error()};
    DeepZoomStore store(picture, records, journal);
    Result<TilesStats> stats = draw(painting, picture, store, threads);
    if (const Result<void> finished = store.finish(); !finished)
        return Error{finished.error()};
    return stats;
}

/// What a file of the whole picture has of a pixel.
int valueOf(float v, int bits)
{
    const float most = bits == 16 ? 65535 : 255;
    return int(most * std::min(v, 1.0f) + 0.5f);
}

} // namespace

class TestTiles : public QObject {
    Q_OBJECT

private slots:
    /// Tiles of all sheets cover each level once; what strokes are prepared for contains the sheet.
    void plans()
    {
        std::mt19937_64 random(1);
        for (int i = 0; i < 40; ++i) {
            const int width = 1 + int(random() % 900), height = 1 + int(random() % 900);
            const TileOptions options{int(16 + random() % 60), int(random() % 4), int(16 + random() % 200), i % 2 == 0};
            const TilePlan plan(View::ofArea(Rect::of(0, 0, 10.0 * width / height, 10), width, height), options);
            QCOMPARE(plan.view().width, width);
            QCOMPARE(plan.levels().front().tiles(), qint64(1));
            std::set<std::array<int, 3>> seen;
            for (qint64 s = 0; s < plan.sheets(); ++s) {
                const TileSheet sheet = plan.sheet(s);
                const PixelRect &a = sheet.pixels, &b = sheet.near;
                QVERIFY(a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height);
                for (int row = sheet.row; row < sheet.row + sheet.rows; ++row)
                    for (int column = sheet.column; column < sheet.column + sheet.columns; ++column) {
                        QVERIFY(seen.insert({sheet.level, column, row}).second);
                        const PixelRect t = plan.tile(sheet.level, column, row);
                        QVERIFY(!t.isEmpty() && t.x >= a.x && t.y >= a.y && t.x + t.width <= a.x + a.width &&
                                t.y + t.height <= a.y + a.height);
                    }
            }
            QCOMPARE(qint64(seen.size()), plan.tiles());
        }
        const TilePlan largest(View::ofArea(Rect::of(0, 0, 1e6, 1e6), maxTiledSide, maxTiledSide), {});
        const TileSheet last = largest.sheet(largest.sheets() - 1);
        QCOMPARE(last.pixels.x + last.pixels.width, maxTiledSide);
        QCOMPARE(last.level, int(largest.levels().size()) - 1);
    }

    void deepZoom_data()
    {
        QTest::addColumn<int>("tile");
        QTest::addColumn<int>("overlap");
        QTest::addColumn<int>("sheet");
        QTest::addColumn<int>("bits");
        QTest::addColumn<bool>("alpha");
        QTest::addColumn<int>("threads");
        QTest::newRow("usual") << 254 << 1 << 0 << 8 << false << 3;
        QTest::newRow("small") << 48 << 0 << 96 << 8 << true << 1;
        QTest::newRow("odd and deep") << 61 << 5 << 130 << 16 << true << 4;
    }
    void deepZoom()
    {
        QFETCH(int, tile);
        QFETCH(int, overlap);
        QFETCH(int, sheet);
        QFETCH(int, bits);
        QFETCH(bool, alpha);
        QFETCH(int, threads);
        QTemporaryDir folder;
        const PaintingPtr painting = somePainting();
        const View view = View::ofArea(Rect::of(13.3, -7, 71, 53), 331, 247);
        const TiledPicture picture =
            tiledPicture(folder.filePath("a.dzi"), view, {tile, overlap, sheet}, TileFormat::Png, bits, alpha);
        const Result<TilesStats> stats = drawDeepZoom(painting, picture, threads);
        QVERIFY2(stats, qPrintable(stats ? QString() : stats.error()));
        QCOMPARE(stats->sheets, picture.plan.sheets());
        TileJournal none;
        const DeepZoomStore store(picture, {}, none);
        for (std::size_t l = 0; l < picture.plan.levels().size(); ++l) {
            const TileLevel &level = picture.plan.levels()[l];
            const FloatPicture whole = wholeOf(painting, level.view, alpha);
            for (int row = 0; row < level.rows; ++row)
                for (int column = 0; column < level.columns; ++column) {
                    const PixelRect at = picture.plan.tile(int(l), column, row);
                    const QString path = store.pathOf(int(l), column, row);
                    const Result<FloatPicture> shown = readImage(bytesOf(path), path);
                    QVERIFY2(shown, qPrintable(path));
                    QCOMPARE(shown->width, at.width);
                    QCOMPARE(shown->height, at.height);
                    for (int y = 0; y < at.height; ++y)
                        for (int i = 0; i < 4 * at.width; ++i)
                            if (i % 4 < 3 || alpha)
                                QCOMPARE(valueOf(shown->at(0, y)[i], bits), valueOf(whole.at(at.x, at.y + y)[i], bits));
                }
        }
        QVERIFY(bytesOf(folder.filePath("a.dzi")).contains("<Size Width=\"331\" Height=\"247\"/>"));
        QVERIFY(bytesOf(folder.filePath("a.html")).contains("\"files\":\"a_files\""));
    }

    void bigTiff_data()
    {
        QTest::addColumn<int>("bits");
        QTest::addColumn<bool>("alpha");
        QTest::newRow("8 bits") << 8 << false;
        QTest::newRow("16 bits and alpha") << 16 << true;
    }
    /// libtiff reads every level.
    void bigTiff()
    {
        QFETCH(int, bits);
        QFETCH(bool, alpha);
        QTemporaryDir folder;
        const PaintingPtr painting = somePainting();
        const View view = View::ofArea(Rect::of(0, 0, 96, 72), 300, 225);
        const TiledPicture picture =
            tiledPicture(folder.filePath("a.tif"), view, {64, 0, 128, false}, TileFormat::Tiff, bits, alpha);
        TileJournal journal;
        const QString path = folder.filePath("a.journal");
        QVERIFY(journal.open(path, picture.identity));
        PackFile file;
        QVERIFY(file.open(folder.filePath("a.part"), bigTiffHead));
        PackStore store({}, journal, file);
        QVERIFY(draw(painting, picture, store));
        const auto records = TileJournal::read(path, picture.identity);
        QVERIFY(records && qint64(records->size()) == picture.plan.sheets());
        QVERIFY(frameBigTiff(picture, file.path(), file.end(), *records));

        const std::unique_ptr<TIFF, void (*)(TIFF *)> tiff(TIFFOpen(qPrintable(picture.path), "r"), TIFFClose);
        QVERIFY(tiff);
        const int channels = alpha ? 4 : 3;
        for (std::size_t l = picture.plan.levels().size(); l-- > 0;) {
            const TileLevel &level = picture.plan.levels()[l];
            const FloatPicture whole = wholeOf(painting, level.view, alpha);
            std::uint32_t width = 0, height = 0;
            TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
            TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
            QCOMPARE(int(width), level.view.width);
            QCOMPARE(int(height), level.view.height);
            std::vector<std::uint8_t> tile(std::size_t(TIFFTileSize(tiff.get())));
            QCOMPARE(tile.size(), std::size_t(64 * 64 * channels * bits / 8));
            for (int y = 0; y < level.view.height; ++y)
                for (int x = 0; x < level.view.width; ++x) {
                    if (x % 64 == 0)
                        QVERIFY(TIFFReadTile(tiff.get(), tile.data(), std::uint32_t(x), std::uint32_t(y), 0, 0) > 0);
                    for (int c = 0; c < channels; ++c) {
                        const std::size_t at = std::size_t((y % 64 * 64 + x % 64) * channels + c);
                        const int value =
                            bits == 8 ? tile[at] : reinterpret_cast<const std::uint16_t *>(tile.data())[at];
                        QCOMPARE(value, valueOf(whole.at(x, y)[c], bits));
                    }
                }
            QCOMPARE(TIFFReadDirectory(tiff.get()), l > 0 ? 1 : 0);
        }
    }

    /// Tiles that are whole stay; what is missing, damaged or was never written down is drawn again, with the same
    /// bits.
    void resumes()
    {
        QTemporaryDir folder;
        const PaintingPtr painting = somePainting(PaperKind::None);
        const View view = View::ofArea(Rect::of(0, 0, 96, 72), 200, 150);
        const TiledPicture picture =
            tiledPicture(folder.filePath("a.dzi"), view, {32, 1, 64}, TileFormat::Jpeg, 8, false);
        QVERIFY(drawDeepZoom(painting, picture));
        const qint64 all = picture.plan.sheets();
        TileJournal none;
        const DeepZoomStore store(picture, {}, none);
        const QString one = store.pathOf(8, 0, 0), other = store.pathOf(8, 6, 4);
        const QByteArray first = bytesOf(one), second = bytesOf(other);

        QCOMPARE(drawDeepZoom(painting, picture)->kept, all);
        QByteArray damaged = first;
        damaged[damaged.size() / 2] = char(damaged[damaged.size() / 2] ^ 1);
        QVERIFY(put(one, damaged));
        QVERIFY(QFile::remove(other));
        QCOMPARE(drawDeepZoom(painting, picture)->sheets, qint64(2));
        QCOMPARE(bytesOf(one), first);
        QCOMPARE(bytesOf(other), second);

        // A journal that was cut off in the middle of a line.
        const QString journal = DeepZoomStore::filesOf(picture.path) + "/tiles.journal";
        const QByteArray lines = bytesOf(journal);
        QVERIFY(put(journal, lines.left(lines.indexOf("sheet 5 ") + 20)));
        const Result<TilesStats> again = drawDeepZoom(painting, picture);
        QVERIFY(again && again->kept > 0 && again->sheets > 0);
        QCOMPARE(again->kept + again->sheets, all);
        QCOMPARE(drawDeepZoom(painting, picture)->kept, all);

        TiledPicture another = picture;
        another.identity = "another picture";
        const Result<TilesStats> refused = drawDeepZoom(painting, another);
        QVERIFY(!refused && refused.error().contains("of another picture"));
    }

    /// In a picture that is wider than 2^30 pixels, and far from the canvas' origin, parts that overlap agree to the
    /// bit.
    void farAndDeep()
    {
        const PaintingPtr painting = somePainting();
        const Rect area = Rect::of(40, 30, 3, 3);
        const View view = View::ofArea(area, maxTiledSide, maxTiledSide);
        const TilePlan plan(view, {256, 1, 256});
        RenderRequest request;
        request.painting = painting;
        request.time = painting->end();
        request.view = view;
        const auto renderer = cpu();
        const auto part = [&](const PixelRect &pixels, const PixelRect &near) {
            request.part = pixels;
            request.near = near;
            FloatPicture out;
            return renderer->render(request, out) ? out : FloatPicture();
        };
        const int at = maxTiledSide - 400;
        const FloatPicture a = part({at, at, 200, 150}, {}),
                           b = part({at + 37, at + 50, 363, 350}, {at - 5000, at - 5000, 5400, 5400});
        QCOMPARE(a.width, 200);
        QCOMPARE(b.height, 350);
        for (int y = 50; y < 150; ++y)
            QVERIFY(std::equal(a.at(37, y), a.at(199, y) + 4, b.at(0, y - 50)));
    }
};

QTEST_GUILESS_MAIN(TestTiles)
#include "test_tiles.moc"
