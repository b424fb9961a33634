// What is read of PDF files that are damaged or made to do harm. It is apart from test_drawing_pdf, which is linked
// with libqpdf: clang, and so the build with sanitizers, cannot compile libqpdf's headers as C++20.
#include "model/formats/pdf/pdf_embedding.h"

#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "render/drawing/drawing_file.h"
#include "tests/render/filled.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

QByteArray outlinesOf(const PaintingPtr &painting)
{
    DrawingOptions options;
    options.kind = DrawingKind::Outlines;
    options.format = DrawingFormat::Pdf;
    options.time = painting->end();
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
    const Result<PreparedDrawing> drawing = prepareDrawing(painting, options, **renderer);
    return drawing ? *bytesOf(*drawing, *painting, "a.pdf") : QByteArray();
}

} // namespace

class TestPdfDocuments : public QObject {
    Q_OBJECT

private slots:
    /// A painting, or a message; and whatever comes out is valid.
    void mutatedFilesDoNoHarm()
    {
        std::mt19937_64 random(23);
        const PaintingPtr p = mixedFills(random, 2, 60, 40, PaperKind::None);
        const QByteArray whole = outlinesOf(p);
        const auto below = [&](qsizetype n) { return qsizetype(random() % quint64(n)); };
        int opened = 0;
        const int all = trials(2000, 50'000);
        for (int i = 0; i < all; ++i) {
            QByteArray bytes = whole;
            for (qsizetype k = 1 + below(4); k > 0; --k) {
                const qsizetype at = below(bytes.size()), length = std::min(1 + below(200), bytes.size() - at);
                switch (random() % 6) {
                case 0:
                    bytes[at] = char(random());
                    break;
                case 1:
                    bytes.remove(at, length);
                    break;
                case 2:
                    bytes.insert(at, bytes.mid(below(bytes.size()), length));
                    break;
                case 3: // A number becomes another one.
                    if (const qsizetype digit = bytes.indexOf('0', at); digit >= 0)
                        bytes[digit] = char('0' + random() % 10);
                    break;
                case 4: // A name becomes another one.
                    if (const qsizetype name = bytes.indexOf('/', at); name >= 0 && name + 2 < bytes.size())
                        bytes[name + 1] = char('A' + random() % 26);
                    break;
                default:
                    bytes.truncate(std::max<qsizetype>(8, at));
                }
            }
            const Result<LoadedDocument> read = readDocument(bytes, "a.pdf");
            if (read)
                QCOMPARE(problemOf(read->painting), QString());
            else
                QVERIFY2(read.error().startsWith("a.pdf: ") && read.error().size() < 1000, qPrintable(read.error()));
            opened += bool(read);
        }
        QVERIFY2(opened > all / 20 && opened < all - all / 20, qPrintable(QString::number(opened)));
    }

    /// A small file does not become a large one in memory.
    void bombsAreRefused()
    {
        const QByteArray zeros(64 << 20, 0);
        const QByteArray bomb = qCompress(zeros, 9).mid(4); // behind Qt's own head
        const QByteArray table =
            "%PDF-1.7\n1 0 obj\n<< /Type /XRef /W [1 3 1] /Size 9 /Root 1 0 R /Filter /FlateDecode "
            "/Length " +
            QByteArray::number(bomb.size()) + " >>\nstream\n" + bomb + "\nendstream\nendobj\nstartxref\n9\n%%EOF\n";
        const Result<LoadedDocument> read = readDocument(table, "a.pdf");
        QVERIFY2(!read && read.error().contains("damaged"), qPrintable(read.error()));
        pdf::Objects objects;
        objects.set(pdf::Objects::pages, "<< /Type /Pages /Count 0 /Kids [] >>");
        objects.set(pdf::Objects::catalogue, "<< /Type /Catalog /Pages 2 0 R " + pdf::attach(objects, {zeros}) + " >>");
        objects.set(pdf::Objects::information, "<< >>");
        const Result<QByteArray> file = pdf::sealedFile(objects);
        QVERIFY(bool(file) && file->size() < 1 << 20);
        const Result<LoadedDocument> large = readDocument(*file, "a.pdf");
        QVERIFY2(!large && large.error().contains("cannot be unpacked"), qPrintable(large.error()));
    }
};

QTEST_GUILESS_MAIN(TestPdfDocuments)
#include "test_pdf_documents.moc"
