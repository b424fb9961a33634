#include "app/dialogs/manual/page_look.h"

#include "app/widgets/look/theme.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QImageReader>
#include <QPalette>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextTable>

#include <algorithm>

namespace suffuse {

namespace {

double pageEm(const QFont &font)
{
    return QFontMetricsF(font).height() * 0.8;
}

struct Look {
    double em; ///< logical pixels
    double size; ///< of the text, points
    QString fixed; ///< family of keys and of what is typed
    const QPalette &palette;
    int width;
};

/// The size that Markdown's headings bring would overrule a size in points.
QTextCharFormat headingFormat(QTextCharFormat format, int level, const Look &look)
{
    constexpr double sizes[] = {1.75, 1.3, 1.08};
    format.clearProperty(QTextFormat::FontSizeAdjustment);
    format.setFontPointSize(look.size * sizes[std::clamp(level, 1, 3) - 1]);
    format.setFontWeight(level == 1 ? QFont::DemiBold : QFont::Bold);
    return format;
}

bool hasPicture(const QTextBlock &block)
{
    return block.begin() != block.end() && block.begin().fragment().charFormat().isImageFormat();
}

/// Spaces around a paragraph, a heading or an entry of a list.
QTextBlockFormat spacesOf(const QTextBlock &block, const Look &look)
{
    QTextBlockFormat format = block.blockFormat();
    const int level = format.headingLevel();
    const bool goesOnAsList = block.textList() && block.next().textList() == block.textList();
    format.setLineHeight(level > 0 || hasPicture(block) ? 100 : 140, QTextBlockFormat::ProportionalHeight);
    format.setTopMargin(level == 1 ? 0.4 * look.em : level > 1 ? 1.6 * look.em : 0);
    format.setBottomMargin(level > 0 ? 0.6 * look.em : goesOnAsList ? 0.35 * look.em : look.em);
    if (format.hasProperty(QTextFormat::BlockCodeLanguage) || format.hasProperty(QTextFormat::BlockCodeFence)) {
        format.setBackground(look.palette.alternateBase());
        format.setLineHeight(100, QTextBlockFormat::ProportionalHeight); // else its ground would be striped
        format.setNonBreakableLines(false);
        format.setLeftMargin(0.8 * look.em);
        const bool goesOn = block.next().isValid() && block.next().blockFormat().hasProperty(QTextFormat::BlockCodeFence);
        format.setTopMargin(0);
        format.setBottomMargin(goesOn ? 0 : look.em);
    }
    return format;
}

void setPicture(QTextCursor &cursor, const QTextFragment &fragment, const Look &look)
{
    QTextImageFormat image = fragment.charFormat().toImageFormat();
    const QSizeF size = shownSize(QImageReader(pictureFile(image.name())).size(), look.width);
    if (size.isEmpty())
        return;
    image.setWidth(size.width());
    image.setHeight(size.height());
    cursor.setCharFormat(image);
}

void setBlock(const QTextBlock &block, const Look &look)
{
    QTextCursor cursor(block);
    const bool inTable = cursor.currentTable();
    if (!inTable)
        cursor.setBlockFormat(spacesOf(block, look));
    else {
        QTextBlockFormat format = block.blockFormat();
        format.setAlignment(Qt::AlignLeft); // cells of the first row would be centred
        format.setLineHeight(125, QTextBlockFormat::ProportionalHeight);
        cursor.setBlockFormat(format);
    }
    const int level = block.blockFormat().headingLevel();
    QList<QTextFragment> fragments;
    for (auto it = block.begin(); !it.atEnd(); ++it)
        fragments << it.fragment();
    for (const QTextFragment &fragment : std::as_const(fragments)) {
        cursor.setPosition(fragment.position());
        cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
        if (fragment.charFormat().isImageFormat())
            setPicture(cursor, fragment, look);
        else if (level > 0)
            cursor.setCharFormat(headingFormat(fragment.charFormat(), level, look));
        else if (fragment.charFormat().fontFixedPitch()) {
            QTextCharFormat code;
            code.setFontFamilies({look.fixed});
            code.setFontPointSize(look.size * 0.95);
            cursor.mergeCharFormat(code);
        }
    }
}

void setTable(QTextTable &table, const Look &look)
{
    QTextTableFormat format = table.format();
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(hairline());
    format.setBorderCollapse(true);
    format.setCellSpacing(0);
    format.setCellPadding(0.4 * look.em);
    format.setTopMargin(0.3 * look.em);
    format.setBottomMargin(0.5 * look.em);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    table.setFormat(format);
    for (int row = 0; row < table.rows(); ++row)
        for (int column = 0; column < table.columns(); ++column) {
            QTextTableCell cell = table.cellAt(row, column);
            QTextCharFormat all = cell.format();
            all.setVerticalAlignment(QTextCharFormat::AlignMiddle);
            if (row == 0)
                all.setBackground(look.palette.alternateBase());
            cell.setFormat(all);
        }
}

void setTables(const QTextFrame &frame, const Look &look)
{
    for (QTextFrame *child : frame.childFrames()) {
        if (auto *table = qobject_cast<QTextTable *>(child))
            setTable(*table, look);
        setTables(*child, look);
    }
}

} // namespace

QString pictureFile(const QString &name)
{
    return ":/manual/pictures/" + name.section('/', -1);
}

QSizeF shownSize(const QSize &pixels, int room)
{
    constexpr double pixelsEach = 1.5; // as docs/manual/pictures.py draws them
    constexpr int least = 80;
    if (pixels.isEmpty())
        return {};
    const double width = std::min<double>(pixels.width() / pixelsEach, std::max(room, least));
    return {width, width * pixels.height() / pixels.width()};
}

double pageMargin(const QFont &font)
{
    return pageEm(font);
}

void setPageLook(QTextDocument &document, const QFont &font, const QPalette &palette, int width)
{
    const Look look{pageEm(font), QFontInfo(font).pointSizeF(),
                    QFontDatabase::systemFont(QFontDatabase::FixedFont).family(), palette, width};
    document.setDefaultFont(font);
    document.setIndentWidth(1.6 * look.em);
    document.setDocumentMargin(pageMargin(font));
    setTables(*document.rootFrame(), look);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        setBlock(block, look);
}

} // namespace suffuse
