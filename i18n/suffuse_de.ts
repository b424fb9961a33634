<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Bench</name>
    <message>
        <source>stopped before all was measured</source>
        <translation>abgebrochen, bevor alles gemessen war</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>es lässt sich kein temporärer Ordner anlegen: %1. Setzen Sie TMPDIR auf einen beschreibbaren Ordner.</translation>
    </message>
    <message>
        <source>there is no stroke to drag in this painting</source>
        <translation>in diesem Bild gibt es keinen Strich, der sich ziehen ließe</translation>
    </message>
    <message>
        <source>measuring %1</source>
        <translation>%1 wird gemessen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>verglichen</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>Gemälde</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>backend</source>
        <translation>Backend</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>Median ms</translation>
    </message>
    <message>
        <source>min ms</source>
        <translation>Minimum ms</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Ink wash</source>
        <translation>Tuschelavierung</translation>
    </message>
    <message>
        <source>Watercolour edge</source>
        <translation>Aquarell mit Rand</translation>
    </message>
    <message>
        <source>Soft airbrush</source>
        <translation>Weicher Airbrush</translation>
    </message>
    <message>
        <source>Flat marker</source>
        <translation>Flacher Marker</translation>
    </message>
    <message>
        <source>Dry chalk</source>
        <translation>Trockene Kreide</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>Pinselstift</translation>
    </message>
    <message>
        <source>Dry brush</source>
        <translation>Trockenpinsel</translation>
    </message>
    <message>
        <source>Ink splash</source>
        <translation>Tuschekleckse</translation>
    </message>
    <message>
        <source>Broad nib</source>
        <translation>Breitfeder</translation>
    </message>
    <message>
        <source>Flat wash</source>
        <translation>Flache Lavierung</translation>
    </message>
    <message>
        <source>Granulating wash</source>
        <translation>Granulierend</translation>
    </message>
    <message>
        <source>Wet in wet</source>
        <translation>Nass in Nass</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>Lasur</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>Zweifarbig</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>Zeichenkohle</translation>
    </message>
    <message>
        <source>Pastel</source>
        <translation>Pastell</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>Gouache</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tusche</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>Aquarell</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>Trocken</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flächig</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Airbrush</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Round wash</source>
        <translation>Runde Lavierung</translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>A&amp;nwenden</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Restore &amp;Defaults</source>
        <translation>&amp;Vorgaben wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Show Details...</source>
        <translation>&amp;Details zeigen …</translation>
    </message>
    <message>
        <source>&amp;Hide Details...</source>
        <translation>&amp;Details verbergen …</translation>
    </message>
</context>
<context>
    <name>ChoosePicture</name>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Pictures and diffusion curves</source>
        <translation>Bilder und Diffusionskurven</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>%1: cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1: kann nicht gelesen werden (%2). Bitte Namen und Rechte prüfen.</translation>
    </message>
    <message>
        <source>%1: has more than 2 GB; that is more than can be opened</source>
        <translation>%1: hat mehr als 2 GB; das ist mehr, als sich öffnen lässt</translation>
    </message>
    <message>
        <source>  bytes     %1</source>
        <translation>  Bytes     %1</translation>
    </message>
    <message>
        <source>  canvas    %1 × %2</source>
        <translation>  Leinwand  %1 × %2</translation>
    </message>
    <message>
        <source>  on paper  %1 × %2 mm, %3 units an inch</source>
        <translation>  Maße      %1 × %2 mm, %3 Einheiten je Zoll</translation>
    </message>
    <message>
        <source>  strokes   %1</source>
        <translation>  Striche   %1</translation>
    </message>
    <message>
        <source>  segments  %1</source>
        <translation>  Segmente  %1</translation>
    </message>
    <message>
        <source>  bounds    none: nothing is painted</source>
        <translation>  Grenzen   keine: Es ist nichts gemalt</translation>
    </message>
    <message>
        <source>  bounds    x %1, y %2, %3 × %4</source>
        <translation>  Grenzen   x %1, y %2, %3 × %4</translation>
    </message>
    <message>
        <source>  duration  %1 s</source>
        <translation>  Dauer     %1 s</translation>
    </message>
    <message>
        <source>  chunk     %1, %2 bytes</source>
        <translation>  Block     %1, %2 Bytes</translation>
    </message>
    <message>
        <source>%1not available: %2</source>
        <translation>%1nicht verfügbar: %2</translation>
    </message>
    <message>
        <source>Tells what a painting or a recording holds.</source>
        <translation>Sagt, was ein Bild oder eine Aufzeichnung enthält.</translation>
    </message>
    <message>
        <source>Prints JSON (docs/cli.md).</source>
        <translation>Gibt JSON aus (docs/cli.md).</translation>
    </message>
    <message>
        <source>The backends and devices there are, and why one is missing.</source>
        <translation>Welche Backends und Geräte es gibt, und warum eines fehlt.</translation>
    </message>
    <message>
        <source>give a file, or --backends</source>
        <translation>bitte eine Datei oder --backends angeben</translation>
    </message>
    <message>
        <source>draw a painting into an image file</source>
        <translation>ein Bild in eine Bilddatei zeichnen</translation>
    </message>
    <message>
        <source>what a file holds; the backends there are</source>
        <translation>was eine Datei enthält; welche Backends es gibt</translation>
    </message>
    <message>
        <source>between documents, the text form and recordings</source>
        <translation>zwischen Dokumenten, der Textform und Aufzeichnungen</translation>
    </message>
    <message>
        <source>what lies at a point of the canvas</source>
        <translation>was an einem Punkt der Leinwand liegt</translation>
    </message>
    <message>
        <source>compare the backends with the reference</source>
        <translation>die Backends mit der Referenz vergleichen</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli COMMAND [options] …</source>
        <translation>Aufruf: suffuse-cli BEFEHL [Optionen] …</translation>
    </message>
    <message>
        <source>%1: there is no such command. See suffuse-cli --help.</source>
        <translation>%1: Diesen Befehl gibt es nicht. Siehe suffuse-cli --help.</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>Zeigt diese Hilfe.</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>zu wenige Argumente</translation>
    </message>
    <message>
        <source>one argument too many: %1</source>
        <translation>ein Argument zu viel: %1</translation>
    </message>
    <message>
        <source>%1: %2. See suffuse-cli %1 --help.</source>
        <translation>%1: %2. Siehe suffuse-cli %1 --help.</translation>
    </message>
    <message>
        <source>standard output cannot be written: %1</source>
        <translation>die Standardausgabe kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>zeichnet</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>der Speicher reicht nicht für %1 × %2 Pixel. Bitte eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>--area %1: give X,Y,W,H in canvas units, W and H above 0</source>
        <translation>--area %1: bitte X,Y,W,H in Leinwandeinheiten angeben, W und H über 0</translation>
    </message>
    <message>
        <source>--size %1: give WxH or W in pixels, e.g. 1024x768</source>
        <translation>--size %1: bitte WxH oder W in Pixeln angeben, z. B. 1024x768</translation>
    </message>
    <message>
        <source>--scale %1: give pixels a unit, above 0, e.g. 2</source>
        <translation>--scale %1: bitte Pixel je Einheit angeben, über 0, z. B. 2</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a smaller --size, --scale or --area</source>
        <translation>ein Bild von %1 × %2 Pixeln ist zu groß: höchstens %3 Millionen Pixel. Bitte --size, --scale oder --area kleiner wählen</translation>
    </message>
    <message>
        <source>%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale or --area</source>
        <translation>%1 Pixel je Einheit liegen außerhalb von 0.001 bis 1e9. Bitte --size, --scale oder --area anders wählen</translation>
    </message>
    <message>
        <source>give --size or --scale, not both</source>
        <translation>bitte --size oder --scale angeben, nicht beides</translation>
    </message>
    <message>
        <source>--size %1: the picture is scaled uniformly, so a width of %2 has the height %3: use --size %2x%3</source>
        <translation>--size %1: Das Bild wird gleichmäßig skaliert, zur Breite %2 gehört die Höhe %3: bitte --size %2x%3 verwenden</translation>
    </message>
    <message>
        <source>--time %1: give a moment in seconds, e.g. 1.5</source>
        <translation>--time %1: bitte einen Zeitpunkt in Sekunden angeben, z. B. 1.5</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu, cuda or reference</source>
        <translation>--backend %1: möglich sind auto, cpu, cuda und reference</translation>
    </message>
    <message>
        <source>--threads %1: give a number from 1 to 1024</source>
        <translation>--threads %1: bitte eine Zahl von 1 bis 1024 angeben</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message>
        <source>stroke %1, %2</source>
        <translation>Strich %1, %2</translation>
    </message>
    <message>
        <source>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (red, yellow, blue, opacity)
  after it: RYB %7, RGB %8
</source>
        <translation>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (Rot, Gelb, Blau, Deckkraft)
  danach: RYB %7, RGB %8
</translation>
    </message>
    <message>
        <source>  fill: φ %1, share %2
</source>
        <translation>  Füllung: φ %1, Anteil %2
</translation>
    </message>
    <message>
        <source>  segment %1: φ %2, share %3
</source>
        <translation>  Segment %1: φ %2, Anteil %3
</translation>
    </message>
    <message>
        <source>at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6
</source>
        <translation>bei %1, %2, %3 s: Papier η %4, Hintergrund RYB %5, RGB %6
</translation>
    </message>
    <message>
        <source>no stroke reaches this point
</source>
        <translation>kein Strich reicht bis hierher
</translation>
    </message>
    <message>
        <source>Tells what lies at a point of the canvas, stroke by stroke from bottom to top. X and Y are in canvas units.</source>
        <translation>Sagt, was an einem Punkt der Leinwand liegt, Strich für Strich von unten nach oben. X und Y in Leinwandeinheiten.</translation>
    </message>
    <message>
        <source>The moment, in seconds (default: the end).</source>
        <translation>Der Zeitpunkt in Sekunden (Vorgabe: das Ende).</translation>
    </message>
    <message>
        <source>%1 %2: give X and Y as numbers, in canvas units</source>
        <translation>%1 %2: bitte X und Y als Zahlen in Leinwandeinheiten angeben</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone; scales uniformly.</source>
        <translation>Pixel: WxH oder nur W; skaliert gleichmäßig.</translation>
    </message>
    <message>
        <source>Pixels a canvas unit (default 1).</source>
        <translation>Pixel je Leinwandeinheit (Vorgabe 1).</translation>
    </message>
    <message>
        <source>Part of the canvas, in canvas units (default: all of it).</source>
        <translation>Teil der Leinwand in Leinwandeinheiten (Vorgabe: alles).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: the end).</source>
        <translation>Der gezeichnete Zeitpunkt in Sekunden (Vorgabe: das Ende).</translation>
    </message>
    <message>
        <source>No background: alpha holds the coverage.</source>
        <translation>Kein Hintergrund: Alpha hält die Deckung.</translation>
    </message>
    <message>
        <source>8, 16, half or float (default: the format&apos;s usual one).</source>
        <translation>8, 16, half oder float (Vorgabe: das Übliche des Formats).</translation>
    </message>
    <message>
        <source>auto, cpu, cuda or reference.</source>
        <translation>auto, cpu, cuda oder reference.</translation>
    </message>
    <message>
        <source>Number of threads (default: one a core).</source>
        <translation>Zahl der Threads (Vorgabe: einer je Kern).</translation>
    </message>
    <message>
        <source>Prints times and counts as JSON.</source>
        <translation>Gibt Zeiten und Zahlen als JSON aus.</translation>
    </message>
    <message>
        <source>--depth %1: give 8, 16, half or float</source>
        <translation>--depth %1: möglich sind 8, 16, half und float</translation>
    </message>
    <message>
        <source>Draws a painting or a recording into an image file.</source>
        <translation>Zeichnet ein Bild oder eine Aufzeichnung in eine Bilddatei.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the picture to write</source>
        <translation>-o OUT fehlt: bitte das zu schreibende Bild nennen</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference R %3, G %4, B %5</source>
        <translation>%1 und %2: größter Unterschied R %3, G %4, B %5</translation>
    </message>
    <message>
        <source>  at pixel %1, %2: RGB %3 and %4</source>
        <translation>  bei Pixel %1, %2: RGB %3 und %4</translation>
    </message>
    <message>
        <source>  %1 of %2 pixels over 1/512</source>
        <translation>  %1 von %2 Pixeln über 1/512</translation>
    </message>
    <message>
        <source>  %1 pixels that are no numbers</source>
        <translation>  %1 Pixel sind keine Zahlen</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference in 8 bits %3, at pixel %4, %5</source>
        <translation>%1 und %2: größter Unterschied in 8 Bit %3, bei Pixel %4, %5</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, at %4 s</source>
        <translation>%1, %2 × %3 Pixel, bei %4 s</translation>
    </message>
    <message>
        <source>within the contract</source>
        <translation>innerhalb der Vereinbarung</translation>
    </message>
    <message>
        <source>OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends</source>
        <translation>ÜBER der Vereinbarung: 1/512 zur Referenz, 1 Stufe in 8 Bit zwischen Backends</translation>
    </message>
    <message>
        <source>Draws a painting on every backend there is and on the reference, and compares the pictures.</source>
        <translation>Zeichnet ein Bild mit jedem Backend und der Referenz und vergleicht die Ergebnisse.</translation>
    </message>
    <message>
        <source>Prints the rows as a JSON array.</source>
        <translation>Gibt die Zeilen als JSON-Feld aus.</translation>
    </message>
    <message>
        <source>Measures on this document instead of a generated painting of figure 11f&apos;s size.</source>
        <translation>Misst an diesem Dokument statt an einem erzeugten Bild von der Größe der Abbildung 11f.</translation>
    </message>
    <message>
        <source>all: every backend that can run here, one after the other.</source>
        <translation>all: nacheinander jedes Backend, das hier laufen kann.</translation>
    </message>
    <message>
        <source>Numbers of threads; several: full renders with each (default: 1, and one a core).</source>
        <translation>Anzahl der Threads; mehrere: vollständige Bilder mit jeder (Vorgabe: 1 und einer je Kern).</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).</source>
        <translation>Pixel: BxH oder nur B (Vorgabe: 1 px je Einheit, vollständige Bilder auch mit 2.8125 px).</translation>
    </message>
    <message>
        <source>Names of rows, with commas between: takes these only.</source>
        <translation>Namen von Zeilen, durch Kommas getrennt: nimmt nur diese.</translation>
    </message>
    <message>
        <source>Runs a row (default: 9).</source>
        <translation>Läufe je Zeile (Vorgabe: 9).</translation>
    </message>
    <message>
        <source>Full renders of all thirteen sizes of the paper&apos;s Table 2 too.</source>
        <translation>Auch vollständige Bilder in allen dreizehn Größen der Tabelle 2 des Artikels.</translation>
    </message>
    <message>
        <source>Range of the generated strokes&apos; spread, in units (default: 6 20).</source>
        <translation>Bereich der Ausbreitung der erzeugten Striche in Einheiten (Vorgabe: 6 20).</translation>
    </message>
    <message>
        <source>Segments of the growth rows (default: 1000,10000,100000).</source>
        <translation>Segmente der Wachstumszeilen (Vorgabe: 1000,10000,100000).</translation>
    </message>
    <message>
        <source>A growth row of 1000000 segments too.</source>
        <translation>Auch eine Wachstumszeile mit 1000000 Segmenten.</translation>
    </message>
    <message>
        <source>Width of the generated painting&apos;s canvas (default: 1024).</source>
        <translation>Breite der Leinwand des erzeugten Bildes (Vorgabe: 1024).</translation>
    </message>
    <message>
        <source>Height of the generated painting&apos;s canvas (default: 768).</source>
        <translation>Höhe der Leinwand des erzeugten Bildes (Vorgabe: 768).</translation>
    </message>
    <message>
        <source>Scale of the generated strokes (default: width / 1024).</source>
        <translation>Maßstab der erzeugten Striche (Vorgabe: Breite / 1024).</translation>
    </message>
    <message>
        <source>--%1 %2: give whole numbers from %3 to %4</source>
        <translation>--%1 %2: geben Sie ganze Zahlen von %3 bis %4 an</translation>
    </message>
    <message>
        <source>--%1 %2: give a number above 0, at most %3</source>
        <translation>--%1 %2: geben Sie eine Zahl über 0 an, höchstens %3</translation>
    </message>
    <message>
        <source>--spread %1: give two numbers, e.g. --spread 6 20</source>
        <translation>--spread %1: geben Sie zwei Zahlen an, z. B. --spread 6 20</translation>
    </message>
    <message>
        <source>--devices %1: give all, or leave it out</source>
        <translation>--devices %1: geben Sie all an oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>--only %1: the rows are %2</source>
        <translation>--only %1: die Zeilen sind %2</translation>
    </message>
    <message>
        <source>Measures how fast this machine draws: the figures of docs/performance.md.</source>
        <translation>Misst, wie schnell dieser Rechner zeichnet: die Zahlen von docs/performance.md.</translation>
    </message>
    <message>
        <source>measure how fast this machine draws</source>
        <translation>misst, wie schnell dieser Rechner zeichnet</translation>
    </message>
    <message>
        <source>--devices %1: give all, or a number of GPUs, at least 1</source>
        <translation>--devices %1: erwartet werden all oder eine Anzahl von GPUs, mindestens 1</translation>
    </message>
    <message>
        <source>--devices is for CUDA: use it with --backend cuda</source>
        <translation>--devices gilt für CUDA: bitte mit --backend cuda verwenden</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the picture, all or a number (default 1).</source>
        <translation>Mit CUDA: GPUs, die sich das Bild teilen, all oder eine Anzahl (sonst 1).</translation>
    </message>
    <message>
        <source>draw a painting while it is painted, as frames</source>
        <translation>das Entstehen eines Bildes zeichnen, als Einzelbilder</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>noch %n s</numerusform>
            <numerusform>noch %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>Frames a second (default 25).</source>
        <translation>Einzelbilder je Sekunde (Vorgabe 25).</translation>
    </message>
    <message>
        <source>Length in seconds (default 10).</source>
        <translation>Länge in Sekunden (Vorgabe 10).</translation>
    </message>
    <message>
        <source>Seconds that are kept of a pause in the painting (default 0.5).</source>
        <translation>Sekunden, die von einer Malpause bleiben (Vorgabe 0.5).</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the frames, all or a number (default 1).</source>
        <translation>Mit CUDA: GPUs, die sich die Einzelbilder teilen, all oder eine Anzahl (Vorgabe 1).</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to 1000000</source>
        <translation>--%1 %2: bitte eine Zahl von %3 bis 1000000 angeben</translation>
    </message>
    <message>
        <source>%1 frames are too many: at most %2. Choose a smaller --fps or --duration</source>
        <translation>%1 Einzelbilder sind zu viele: höchstens %2. Bitte --fps oder --duration kleiner wählen</translation>
    </message>
    <message>
        <source>Draws a painting while it is painted, frame by frame.</source>
        <translation>Zeichnet das Entstehen eines Bildes, Einzelbild für Einzelbild.</translation>
    </message>
    <message>
        <source>--brush %1: there is no such brush nor file; choose a file or one of %2</source>
        <translation>--brush %1: diesen Pinsel oder diese Datei gibt es nicht; möglich sind eine Datei oder %2</translation>
    </message>
    <message>
        <source>Frames with their number, film/%05d.png; or film.webp, .webm or .mp4.</source>
        <translation>Einzelbilder mit ihrer Nummer, film/%05d.png; oder film.webp, .webm oder .mp4.</translation>
    </message>
    <message>
        <source>WebP: plays once instead of again and again.</source>
        <translation>WebP: spielt einmal statt immer wieder.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the frames or the film to write</source>
        <translation>-o OUT fehlt: bitte die zu schreibenden Einzelbilder oder den Film nennen</translation>
    </message>
    <message>
        <source>Leaves out what lies beside the picture: preview, view, undo history.</source>
        <translation>Lässt weg, was neben dem Bild liegt: Vorschau, Ansicht, Rückgängig-Schritte.</translation>
    </message>
    <message>
        <source>Of a damaged document takes what is whole, and says what is missing.</source>
        <translation>Nimmt von einem beschädigten Dokument, was heil ist, und sagt, was fehlt.</translation>
    </message>
    <message>
        <source>%1: is damaged; --salvage writes what is whole of it</source>
        <translation>%1: ist beschädigt; --salvage schreibt, was davon heil ist</translation>
    </message>
    <message>
        <source>segments added: %1</source>
        <translation>Segmente hinzugefügt: %1</translation>
    </message>
    <message>
        <source>segments removed: %1</source>
        <translation>Segmente entfernt: %1</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same painting</source>
        <translation>%1 und %2 enthalten dasselbe Bild</translation>
    </message>
    <message>
        <source>%1, segments: %2</source>
        <translation>%1, Segmente: %2</translation>
    </message>
    <message>
        <source>%1: from place %2 to %3</source>
        <translation>%1: von Platz %2 nach %3</translation>
    </message>
    <message>
        <source>Compares two paintings and tells what was added, removed and changed from A to B.</source>
        <translation>Vergleicht zwei Bilder und sagt, was von A nach B hinzukam, entfiel und sich änderte.</translation>
    </message>
    <message>
        <source>only one of the two can be standard input</source>
        <translation>nur eines von beiden kann die Standardeingabe sein</translation>
    </message>
    <message>
        <source>A picture that shows where: B pale, added strokes green, removed ones orange, changed and moved ones blue.</source>
        <translation>Ein Bild, das zeigt, wo: B blass, neue Striche grün, entfernte orange, geänderte und verschobene blau.</translation>
    </message>
    <message>
        <source>--%1 is for the picture; give -o OUT too</source>
        <translation>--%1 gilt für das Bild; bitte auch -o OUT angeben</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>die letzte Ansicht</translation>
    </message>
    <message>
        <source>undo history</source>
        <translation>Rückgängig-Schritte</translation>
    </message>
    <message>
        <source>colour profile</source>
        <translation>Farbprofil</translation>
    </message>
    <message>
        <source>size on paper</source>
        <translation>Größe auf Papier</translation>
    </message>
    <message>
        <source>unknown to this version, kept</source>
        <translation>dieser Version unbekannt, bleibt erhalten</translation>
    </message>
    <message>
        <source>  chunk     %1 at byte %2 is damaged: %3</source>
        <translation>  Block     %1 bei Byte %2 ist beschädigt: %3</translation>
    </message>
    <message>
        <source>  paper     %1</source>
        <translation>  Papier    %1</translation>
    </message>
    <message>
        <source>what differs between two paintings, and where</source>
        <translation>was sich zwischen zwei Bildern unterscheidet, und wo</translation>
    </message>
    <message>
        <source>what was not saved when the editor ended</source>
        <translation>was beim Ende des Programms nicht gespeichert war</translation>
    </message>
    <message>
        <source>in use by a running Suffuse</source>
        <translation>von einem laufenden Suffuse benutzt</translation>
    </message>
    <message>
        <source>There is nothing to recover.
</source>
        <translation>Es gibt nichts wiederherzustellen.
</translation>
    </message>
    <message>
        <source>Lists what was painted and not saved when Suffuse ended unexpectedly, or writes one of it to a file.</source>
        <translation>Listet auf, was gemalt und nicht gespeichert war, als Suffuse unerwartet endete, oder schreibt eines davon in eine Datei.</translation>
    </message>
    <message>
        <source>Lists what there is; the same as no ID.</source>
        <translation>Listet auf, was es gibt; dasselbe wie ohne ID.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json.</source>
        <translation>Die zu schreibende Datei: .suffuse oder .json.</translation>
    </message>
    <message>
        <source>give an ID and -o OUT, or neither</source>
        <translation>bitte eine ID und -o OUT angeben oder keins von beiden</translation>
    </message>
    <message>
        <source>%1: there is no such journal to recover. See suffuse-cli recover --list.</source>
        <translation>%1: ein solches Journal gibt es nicht. Siehe suffuse-cli recover --list.</translation>
    </message>
    <message>
        <source>The brush that recordings and drawings are painted with: a name, or a brush file.</source>
        <translation>Der Pinsel, mit dem Aufnahmen und Zeichnungen gemalt werden: ein Name oder eine Pinseldatei.</translation>
    </message>
    <message>
        <source>%1: is IN itself, which would be lost; give OUT another name</source>
        <translation>%1: ist IN selbst, das verloren ginge; geben Sie OUT einen anderen Namen</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read; -: standard input.</source>
        <translation>Das Bild, die Aufzeichnung oder Zeichnung, die gelesen wird; -: Standardeingabe.</translation>
    </message>
    <message>
        <source>The painting before; -: standard input.</source>
        <translation>Das Bild vorher; -: Standardeingabe.</translation>
    </message>
    <message>
        <source>The painting after; -: standard input.</source>
        <translation>Das Bild nachher; -: Standardeingabe.</translation>
    </message>
    <message>
        <source>How far right of the canvas&apos; left edge, in canvas units.</source>
        <translation>Wie weit rechts vom linken Rand der Leinwand, in Leinwandeinheiten.</translation>
    </message>
    <message>
        <source>How far below the canvas&apos; upper edge, in canvas units.</source>
        <translation>Wie weit unter dem oberen Rand der Leinwand, in Leinwandeinheiten.</translation>
    </message>
    <message>
        <source>Which one, as the list names it.</source>
        <translation>Welches, wie die Liste es nennt.</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli %1 [options]</source>
        <translation>Aufruf: suffuse-cli %1 [Optionen]</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 ist zweimal angegeben; geben Sie es einmal an</translation>
    </message>
    <message>
        <source>--time %1: nothing is painted before %2 s</source>
        <translation>--time %1: Vor %2 s ist nichts gemalt</translation>
    </message>
    <message>
        <source>--format is for an OUT of -; the ending of %1 chooses the format</source>
        <translation>--format gilt, wenn OUT - ist; bei %1 bestimmt die Endung das Format</translation>
    </message>
    <message>
        <source>--brush is ignored: the strokes of %1 have their looks already</source>
        <translation>--brush bleibt ohne Wirkung: die Striche von %1 haben ihr Aussehen schon</translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1: sein einziger Strich ist nicht heil; bitte eine Sicherung öffnen</numerusform>
            <numerusform>%1: keiner der %n Striche ist heil; bitte eine Sicherung öffnen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2: %3, %4 removed, %5 changed, %6 moved</source>
        <translation>%1 → %2: %3, %4 entfernt, %5 geändert, %6 verschoben</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>%n Strich hinzugefügt</numerusform>
            <numerusform>%n Striche hinzugefügt</numerusform>
        </translation>
    </message>
    <message>
        <source>suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help COMMAND. An input of - is standard input.
Exit codes: 0 done, 1 the work failed, 2 wrong usage.</source>
        <translation>suffuse-cli BEFEHL --help zeigt die Optionen eines Befehls, ebenso suffuse-cli help BEFEHL. Eine Eingabe von - ist die Standardeingabe.
Rückgabewerte: 0 erledigt, 1 fehlgeschlagen, 2 falscher Aufruf.</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json; -: standard output.</source>
        <translation>Die Datei, die geschrieben wird: .suffuse oder .json; -: Standardausgabe.</translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  %n Segment mit einem Anteil unter %1 weggelassen (--all)
</numerusform>
            <numerusform>  %n Segmente mit einem Anteil unter %1 weggelassen (--all)
</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists segments with shares below a millionth, too.</source>
        <translation>Nennt auch Segmente mit Anteilen unter einem Millionstel.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n Strich</numerusform>
            <numerusform>%n Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>-o %1: what is recovered is a painting: give a name that ends in .suffuse or .json. suffuse-cli render draws it then</source>
        <translation>-o %1: Wiederhergestellt wird ein Gemälde: bitte einen Namen mit der Endung .suffuse oder .json angeben. suffuse-cli render zeichnet es dann</translation>
    </message>
    <message>
        <source>The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: its layers; -: standard output.</source>
        <translation>Das Bild: .png, .tiff, .exr, .jpg, .webp oder .pfm; .ora oder .psd: seine Ebenen; -: Standardausgabe.</translation>
    </message>
    <message>
        <source>With -o -: png, tiff, exr, jpg, webp or pfm (default: png).</source>
        <translation>Mit -o -: png, tiff, exr, jpg, webp oder pfm (sonst: png).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100.</source>
        <translation>Von JPEG und WebP, 1 bis 100 (sonst 92); WebP verliert bei 100 nichts.</translation>
    </message>
    <message>
        <source>Pixels an inch, as the file says it (default: what makes the picture as large on paper as IN says that it is; else it says nothing).</source>
        <translation>Pixel je Zoll, wie die Datei sie nennt (sonst so viele, dass das Bild auf Papier so groß ist, wie IN es sagt; sagt IN nichts, nennt sie keine).</translation>
    </message>
    <message>
        <source>--format is for -o -; the ending of %1 chooses the format</source>
        <translation>--format gilt für -o -; bei %1 bestimmt die Endung das Format</translation>
    </message>
    <message>
        <source>--stats and -o - both write to standard output; give one</source>
        <translation>--stats und -o - schreiben beide auf die Standardausgabe; bitte nur eines angeben</translation>
    </message>
    <message>
        <source>standard output is a terminal, which shows no pictures; lead it into a file or a program</source>
        <translation>die Standardausgabe ist ein Terminal, das keine Bilder zeigt; bitte in eine Datei oder ein Programm leiten</translation>
    </message>
    <message>
        <source>--format %1: give one of %2</source>
        <translation>--format %1: eines von %2 angeben</translation>
    </message>
    <message>
        <source>--quality %1: give a whole number from 1 to 100</source>
        <translation>--quality %1: eine ganze Zahl von 1 bis 100 angeben</translation>
    </message>
    <message>
        <source>--quality is ignored: %1 loses nothing</source>
        <translation>--quality bleibt ohne Wirkung: %1 verliert nichts</translation>
    </message>
    <message>
        <source>--dpi %1: give a number from 1 to 10000, e.g. 300</source>
        <translation>--dpi %1: eine Zahl von 1 bis 10000 angeben, z. B. 300</translation>
    </message>
    <message>
        <source>--dpi is ignored: %1 files hold no resolution</source>
        <translation>--dpi bleibt ohne Wirkung: %1-Dateien nennen keine Auflösung</translation>
    </message>
    <message>
        <source>  segment %1 fades: φ %2, which leaves %3
</source>
        <translation>  Segment %1 lässt verblassen: φ %2, es bleibt %3
</translation>
    </message>
    <message>
        <source>  segment %1 lifts: φ %2, share %3
</source>
        <translation>  Segment %1 nimmt weg: φ %2, Anteil %3
</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, is missing or of another version, so texts are left out; install Suffuse again, with what suffuse-cli recommends</source>
        <translation>ein Teil von Suffuse, %1, fehlt oder gehört zu einer anderen Version, daher werden Texte weggelassen; installieren Sie Suffuse neu, mit dem, was suffuse-cli empfiehlt</translation>
    </message>
    <message>
        <source>  groups    %1</source>
        <translation>  Gruppen   %1</translation>
    </message>
    <message>
        <source>%1 of them blending</source>
        <translation>davon %1 mit eigener Mischung</translation>
    </message>
    <message>
        <source>%1 clipped</source>
        <translation>%1 begrenzt</translation>
    </message>
    <message>
        <source>%1 masking</source>
        <translation>%1 als Maske</translation>
    </message>
    <message>
        <source>%1 a wash</source>
        <translation>%1 als Lavierung</translation>
    </message>
    <message>
        <source>--transparent: the background is a layer of its own, which other programs can hide</source>
        <translation>--transparent: Der Hintergrund ist eine eigene Ebene, die andere Programme verbergen können</translation>
    </message>
    <message>
        <source>--depth %1: layers have 8 or 16 bits</source>
        <translation>--depth %1: Ebenen haben 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>--%1 is ignored: it is not for layered files</source>
        <translation>--%1 wird übergangen: Das gibt es bei Dateien mit Ebenen nicht</translation>
    </message>
    <message>
        <source>drawing layers</source>
        <translation>Ebenen werden gezeichnet</translation>
    </message>
    <message>
        <source>there is not enough memory for layers of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>Für Ebenen von %1 × %2 Pixeln reicht der Speicher nicht. Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n Gruppe sähe in anderen Programmen anders aus; ihre Ebene zeigt stattdessen, was sie aus dem Bild macht</numerusform>
            <numerusform>%n Gruppen sähen in anderen Programmen anders aus; ihre Ebenen zeigen stattdessen, was sie aus dem Bild machen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 shown alone</source>
        <translation>%1 allein gezeigt</translation>
    </message>
    <message>
        <source>%1 a draft</source>
        <translation>%1 Entwurf</translation>
    </message>
    <message>
        <source>  pictures  %1</source>
        <translation>  Bilder    %1</translation>
    </message>
    <message>
        <source>Draws groups that are drafts, too.</source>
        <translation>Zeichnet auch Gruppen, die Entwürfe sind.</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf</source>
        <translation>%1: unbekannte Endung; möglich sind .suffuse, .json, .svg, .svgz und .pdf</translation>
    </message>
    <message>
        <source>Converts between documents (.suffuse) and the text form (.json), and from pen recordings and drawings, and to drawings (.svg, .svgz, .pdf). What IN is, is found from its content; what OUT is, from its ending.</source>
        <translation>Wandelt zwischen Dokumenten (.suffuse) und der Textform (.json) um, von Stiftaufnahmen und Zeichnungen, und in Zeichnungen (.svg, .svgz, .pdf). Was IN ist, zeigt sein Inhalt; was OUT ist, seine Endung.</translation>
    </message>
    <message>
        <source>--format %1: give suffuse, json, svg or pdf</source>
        <translation>--format %1: suffuse, json, svg oder pdf angeben</translation>
    </message>
    <message>
        <source>Where OUT is -: suffuse, json, svg or pdf (default: json).</source>
        <translation>Wenn OUT - ist: suffuse, json, svg oder pdf (sonst: json).</translation>
    </message>
    <message>
        <source>--%1 is for drawings; give OUT the ending .svg or .pdf</source>
        <translation>--%1 gilt für Zeichnungen; OUT die Endung .svg oder .pdf geben</translation>
    </message>
    <message>
        <source>--as %1: give outlines, bands or hybrid</source>
        <translation>--as %1: outlines, bands oder hybrid angeben</translation>
    </message>
    <message>
        <source>--bands %1: give a whole number from 1 to %2</source>
        <translation>--bands %1: eine ganze Zahl von 1 bis %2 angeben</translation>
    </message>
    <message>
        <source>--bands is for --as bands; leave one of them out</source>
        <translation>--bands gilt für --as bands; eines davon weglassen</translation>
    </message>
    <message>
        <source>Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands (contours within each other, as opaque as the paint; the default) or hybrid (the exact picture under unpainted outlines).</source>
        <translation>Wenn OUT eine Zeichnung ist (.svg, .svgz, .pdf): outlines (ein Pfad je Strich), bands (Höhenlinien ineinander, so deckend wie die Farbe; sonst gewählt) oder hybrid (das genaue Bild unter Umrissen ohne Farbe).</translation>
    </message>
    <message>
        <source>How many bands full opacity has, 1 to 256 (default: 16).</source>
        <translation>Wie viele Bänder volle Deckkraft hat, 1 bis 256 (sonst 16).</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: all dried).</source>
        <translation>Der gezeichnete Zeitpunkt in Sekunden (sonst: alles getrocknet).</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>ICC profile of RGB colours that the file has (default: sRGB).</source>
        <translation>ICC-Profil für RGB-Farben, das die Datei hat (Vorgabe: sRGB).</translation>
    </message>
    <message>
        <source>--profile %1: %2; give an ICC profile of RGB colours</source>
        <translation>--profile %1: %2; ein ICC-Profil für RGB-Farben angeben</translation>
    </message>
    <message>
        <source>Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, into which the sheet fits (default: the sheet as large as it is on paper; where that is not said, 96 units are an inch).</source>
        <translation>Wo OUT eine PDF-Datei ist: A3, A4, A5, Letter oder eine Größe wie 200x150mm oder 8x6in, in die das Blatt passt (sonst das Blatt, so groß wie es auf Papier ist; wo das nicht gesagt ist, sind 96 Einheiten ein Zoll).</translation>
    </message>
    <message>
        <source>--page is for PDF; give OUT the ending .pdf</source>
        <translation>--page gilt für PDF; OUT die Endung .pdf geben</translation>
    </message>
    <message>
        <source>--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in</source>
        <translation>--page %1: A3, A4, A5, Letter oder eine Größe wie 200x150mm oder 8x6in angeben</translation>
    </message>
    <message>
        <source>several INs become the pages of a PDF; give OUT the ending .pdf</source>
        <translation>mehrere IN werden Seiten eines PDFs; OUT die Endung .pdf geben</translation>
    </message>
    <message>
        <source>%1 is a picture: suffuse-cli render IN -o OUT writes pictures</source>
        <translation>%1 ist ein Bild: Bilder schreibt suffuse-cli render IN -o OUT</translation>
    </message>
    <message>
        <source>The painting to write: .suffuse or .json.</source>
        <translation>Das Bild, das geschrieben wird: .suffuse oder .json.</translation>
    </message>
    <message>
        <source>At most so many strokes (default 512).</source>
        <translation>Höchstens so viele Striche (sonst 512).</translation>
    </message>
    <message>
        <source>At most so many numbers, 27 for each stroke.</source>
        <translation>Höchstens so viele Zahlen, 27 je Strich.</translation>
    </message>
    <message>
        <source>As many strokes as this root mean square error needs, in 255ths.</source>
        <translation>So viele Striche, wie dieser mittlere quadratische Fehler braucht, in 255steln.</translation>
    </message>
    <message>
        <source>So many paints, which become linked swatches.</source>
        <translation>So viele Farben; sie werden verknüpfte Farbfelder.</translation>
    </message>
    <message>
        <source>feathering (default), uniform or edge.</source>
        <translation>feathering (sonst), uniform oder edge.</translation>
    </message>
    <message>
        <source>No stroke is narrower, pixels of PICTURE.</source>
        <translation>Kein Strich ist schmaler, in Pixeln von PICTURE.</translation>
    </message>
    <message>
        <source>No stroke is wider, pixels of PICTURE.</source>
        <translation>Kein Strich ist breiter, in Pixeln von PICTURE.</translation>
    </message>
    <message>
        <source>Another picture, white where PICTURE counts and black where not.</source>
        <translation>Ein weiteres Bild: weiß, wo PICTURE zählt, und schwarz, wo nicht.</translation>
    </message>
    <message>
        <source>The share of the error as people see it, 0 (default) to 1.</source>
        <translation>Der Anteil des Fehlers, wie Menschen ihn sehen, 0 (sonst) bis 1.</translation>
    </message>
    <message>
        <source>Goes on with a painting that was fitted before.</source>
        <translation>Macht mit einem Bild weiter, das schon angepasst wurde.</translation>
    </message>
    <message>
        <source>How many steps (default 1200).</source>
        <translation>Wie viele Schritte (sonst 1200).</translation>
    </message>
    <message>
        <source>PICTURE is averaged down to so many pixels (default 600000).</source>
        <translation>PICTURE wird auf so viele Pixel gemittelt (sonst 600000).</translation>
    </message>
    <message>
        <source>Other numbers give other strokes (default 1).</source>
        <translation>Andere Zahlen ergeben andere Striche (sonst 1).</translation>
    </message>
    <message>
        <source>Prints how near the painting comes, as JSON (docs/cli.md).</source>
        <translation>Gibt als JSON aus, wie nahe das Bild kommt (docs/cli.md).</translation>
    </message>
    <message>
        <source>--%1 %2: give a whole number from %3 to %4</source>
        <translation>--%1 %2: bitte eine ganze Zahl von %3 bis %4 angeben</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to %4</source>
        <translation>--%1 %2: bitte eine Zahl von %3 bis %4 angeben</translation>
    </message>
    <message>
        <source>--style %1: give feathering, uniform or edge</source>
        <translation>--style %1: bitte feathering, uniform oder edge angeben</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the painting to write</source>
        <translation>-o OUT fehlt: bitte das Bild nennen, das geschrieben wird</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse or .json</source>
        <translation>%1: unbekannte Endung; bitte .suffuse oder .json verwenden</translation>
    </message>
    <message>
        <source>--strokes and --numbers say the same; give one of them</source>
        <translation>--strokes und --numbers sagen dasselbe; bitte nur eines angeben</translation>
    </message>
    <message>
        <source>--style goes without --from, whose strokes have a style already</source>
        <translation>--style gilt nur ohne --from, dessen Striche schon einen Stil haben</translation>
    </message>
    <message>
        <source>--greatest-width %1 is below --least-width %2</source>
        <translation>--greatest-width %1 liegt unter --least-width %2</translation>
    </message>
    <message>
        <source>%1: is a painting already; draw it with suffuse-cli render first</source>
        <translation>%1: ist schon ein gemaltes Bild; bitte erst mit suffuse-cli render zeichnen</translation>
    </message>
    <message>
        <source>%1: there is no folder %2</source>
        <translation>%1: es gibt keinen Ordner %2</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>passt an</translation>
    </message>
    <message>
        <source>stopped; %1 has the strokes so far, and --from %1 goes on</source>
        <translation>angehalten; %1 hat die bisherigen Striche, und --from %1 macht weiter</translation>
    </message>
    <message>
        <source>Makes strokes that look like a picture, from the back to the front and large before small.</source>
        <translation>Macht Striche, die wie ein Bild aussehen, von hinten nach vorn und große vor kleinen.</translation>
    </message>
    <message>
        <source>there is not enough memory to fit %1. Choose fewer --pixels.</source>
        <translation>der Speicher reicht nicht, um %1 anzupassen. Bitte weniger --pixels wählen.</translation>
    </message>
    <message>
        <source>make a painting of a picture</source>
        <translation>ein Bild aus einem Bild malen</translation>
    </message>
    <message>
        <source>--strokes goes with --fit, which makes strokes of a picture</source>
        <translation>--strokes gehört zu --fit, das aus einem Bild Striche macht</translation>
    </message>
    <message>
        <source>--%1 says nothing of a picture that is fitted; leave it out</source>
        <translation>--%1 sagt nichts über ein Bild, das angepasst wird; lassen Sie es weg</translation>
    </message>
    <message>
        <source>--fit takes one IN at a time</source>
        <translation>--fit nimmt nur ein IN auf einmal</translation>
    </message>
    <message>
        <source>Solves the diffusion curves of IN, or reads its picture, and makes strokes that look like it, as suffuse-cli fit does.</source>
        <translation>Löst die Diffusionskurven von IN oder liest sein Bild und macht Striche, die so aussehen, wie suffuse-cli fit es tut.</translation>
    </message>
    <message>
        <source>With --fit: at most so many strokes (default 512).</source>
        <translation>Mit --fit: höchstens so viele Striche (Vorgabe 512).</translation>
    </message>
    <message>
        <source>Also writes the picture that is fitted, as it was read, averaged or solved.</source>
        <translation>Schreibt auch das Bild, das angepasst wird, so wie es gelesen, gemittelt oder gelöst wurde.</translation>
    </message>
    <message>
        <source>--target %1: unknown ending; use one of %2</source>
        <translation>--target %1: unbekannte Endung; nehmen Sie eine von %2</translation>
    </message>
    <message>
        <source>The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: standard input.</source>
        <translation>Das Bild, das gelesen wird: PNG, JPEG, TIFF, EXR, WebP oder Diffusionskurven (XML); -: Standardeingabe.</translation>
    </message>
    <message>
        <source>make fewer strokes that look like those of a painting</source>
        <translation>weniger Striche machen, die wie die eines Gemäldes aussehen</translation>
    </message>
    <message>
        <source>The strokes to make anew, by their ids, such as 3,7,20-180 (default: all).</source>
        <translation>Die Striche, die neu gemacht werden, nach ihren Nummern, etwa 3,7,20-180 (Vorgabe: alle).</translation>
    </message>
    <message>
        <source>All strokes of the group of that name, in place of --select.</source>
        <translation>Alle Striche der Gruppe dieses Namens, anstelle von --select.</translation>
    </message>
    <message>
        <source>A picture, or another painting, that the whole is to look like (default: as it does).</source>
        <translation>Ein Bild oder ein anderes Gemälde, wie das Ganze aussehen soll (Vorgabe: so wie jetzt).</translation>
    </message>
    <message>
        <source>At most so many strokes (default: a quarter of those before).</source>
        <translation>Höchstens so viele Striche (Vorgabe: ein Viertel der bisherigen).</translation>
    </message>
    <message>
        <source>What the strokes reach is fitted at so many pixels (default 600000).</source>
        <translation>Was die Striche erreichen, wird mit so vielen Pixeln angepasst (Vorgabe 600000).</translation>
    </message>
    <message>
        <source>Says how near the painting comes as JSON (docs/cli.md).</source>
        <translation>Sagt als JSON, wie nahe das Gemälde kommt (docs/cli.md).</translation>
    </message>
    <message>
        <source>--select and --layer both say which strokes; give one of them</source>
        <translation>--select und --layer sagen beide, welche Striche; geben Sie eines davon an</translation>
    </message>
    <message>
        <source>--select %1: give ids of strokes, such as 3,7,20-180</source>
        <translation>--select %1: geben Sie Nummern von Strichen an, etwa 3,7,20-180</translation>
    </message>
    <message>
        <source>--select %1: there is no stroke %2; suffuse-cli convert IN OUT.json shows the ids</source>
        <translation>--select %1: es gibt keinen Strich %2; suffuse-cli convert IN OUT.json zeigt die Nummern</translation>
    </message>
    <message>
        <source>--layer %1: several groups have that name; rename one of them</source>
        <translation>--layer %1: mehrere Gruppen heißen so; benennen Sie eine davon um</translation>
    </message>
    <message>
        <source>--layer %1: there is no group of that name</source>
        <translation>--layer %1: es gibt keine Gruppe dieses Namens</translation>
    </message>
    <message>
        <source>%1: is empty</source>
        <translation>%1: ist leer</translation>
    </message>
    <message>
        <source>%1 strokes in place of %2. Where they are seen, the picture is %3 of 255 from what it should be (root mean square), %4 at most.</source>
        <translation>%1 Striche anstelle von %2. Wo sie zu sehen sind, weicht das Bild um %3 von 255 von dem ab, was es sein soll (quadratisches Mittel), um höchstens %4.</translation>
    </message>
    <message>
        <source>Before it was %1, %2 at most.</source>
        <translation>Vorher waren es %1, höchstens %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%n Strich, der dazwischen lag, liegt jetzt darunter.</numerusform>
            <numerusform>%n Striche, die dazwischen lagen, liegen jetzt darunter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes fewer strokes that look like those of a painting, or makes them look like a picture, and says how near they come.</source>
        <translation>Macht weniger Striche, die wie die eines Gemäldes aussehen, oder macht, dass sie wie ein Bild aussehen, und sagt, wie nahe sie kommen.</translation>
    </message>
    <message>
        <source>a small picture of a painting, for file managers</source>
        <translation>ein kleines Bild eines Gemäldes, für Dateiverwaltungen</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read.</source>
        <translation>Das Gemälde, die Aufnahme oder die Zeichnung, die gelesen wird.</translation>
    </message>
    <message>
        <source>The PNG file to write; -: standard output.</source>
        <translation>Die PNG-Datei, die geschrieben wird; -: Standardausgabe.</translation>
    </message>
    <message>
        <source>So many pixels a side at most, 1 to 1024.</source>
        <translation>Höchstens so viele Pixel je Seite, 1 bis 1024.</translation>
    </message>
    <message>
        <source>Writes a small picture of a painting as a PNG file: the preview in the file, if it has one. File managers call this.</source>
        <translation>Schreibt ein kleines Bild eines Gemäldes als PNG-Datei: die Vorschau in der Datei, wenn sie eine hat. Dateiverwaltungen rufen das auf.</translation>
    </message>
    <message>
        <source>%1: give SIDE as a whole number of pixels from 1 to %2</source>
        <translation>%1: SIDE muss eine ganze Zahl von Pixeln von 1 bis %2 sein</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are there</source>
        <translation>%1 von %2 Stücken sind da</translation>
    </message>
    <message>
        <source>%1: frames %2 are missing</source>
        <translation>%1: Die Bilder %2 fehlen</translation>
    </message>
    <message>
        <source>%1: sheets %2 are missing</source>
        <translation>%1: Die Bögen %2 fehlen</translation>
    </message>
    <message>
        <source>%1: two workers made different bits of piece %2. One of the machines is faulty: find it by the names in %3, remove its journal there, and run the tasks again.</source>
        <translation>%1: Zwei Arbeiter haben aus Stück %2 verschiedene Bits gemacht. Einer der Rechner ist fehlerhaft: Finden Sie ihn anhand der Namen in %3, entfernen Sie dort sein Journal und führen Sie die Aufgaben noch einmal aus.</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>joining</source>
        <translation>Zusammenfügen</translation>
    </message>
    <message>
        <source>%1: sheet %2 cannot be read any more. Run the tasks again.</source>
        <translation>%1: Bogen %2 lässt sich nicht mehr lesen. Führen Sie die Aufgaben noch einmal aus.</translation>
    </message>
    <message>
        <source>Says what is missing, by what workers wrote down.</source>
        <translation>Sagt, was fehlt, nach den Aufzeichnungen der Arbeiter.</translation>
    </message>
    <message>
        <source>Says what is missing or damaged, by reading all of it.</source>
        <translation>Sagt, was fehlt oder beschädigt ist, indem alles gelesen wird.</translation>
    </message>
    <message>
        <source>Puts the pictures together, once all is there and whole.</source>
        <translation>Fügt die Bilder zusammen, sobald alles da und unversehrt ist.</translation>
    </message>
    <message>
        <source>Nothing was joined. Run the tasks again: they draw what is missing.</source>
        <translation>Nichts wurde zusammengefügt. Führen Sie die Aufgaben noch einmal aus: Sie zeichnen, was fehlt.</translation>
    </message>
    <message>
        <source>say what is to be drawn, in a shared folder</source>
        <translation>in einem gemeinsamen Ordner sagen, was zu zeichnen ist</translation>
    </message>
    <message>
        <source>draw a part of it, on any machine</source>
        <translation>einen Teil davon zeichnen, auf einem beliebigen Rechner</translation>
    </message>
    <message>
        <source>what is missing</source>
        <translation>was fehlt</translation>
    </message>
    <message>
        <source>read all that is there, and compare the hashes</source>
        <translation>alles lesen, was da ist, und die Hashwerte vergleichen</translation>
    </message>
    <message>
        <source>put the pictures together</source>
        <translation>die Bilder zusammenfügen</translation>
    </message>
    <message>
        <source>submit the work as a job array of Slurm</source>
        <translation>die Arbeit als Job-Array an Slurm geben</translation>
    </message>
    <message>
        <source>print the work as an Open Job Description</source>
        <translation>die Arbeit als Open Job Description ausgeben</translation>
    </message>
    <message>
        <source>print the work as a job type of Flamenco</source>
        <translation>die Arbeit als Job-Typ von Flamenco ausgeben</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli farm COMMAND [options] …</source>
        <translation>Aufruf: suffuse-cli farm BEFEHL [Optionen] …</translation>
    </message>
    <message>
        <source>farm %1: there is no such command. See suffuse-cli farm --help.</source>
        <translation>farm %1: Diesen Befehl gibt es nicht. Siehe suffuse-cli farm --help.</translation>
    </message>
    <message>
        <source>Into how many tasks the work is divided (default: one for 64 pieces).</source>
        <translation>In wie viele Aufgaben die Arbeit geteilt wird (Vorgabe: eine für 64 Stücke).</translation>
    </message>
    <message>
        <source>--tasks %1: give a whole number, at least 1</source>
        <translation>--tasks %1: Geben Sie eine ganze Zahl an, mindestens 1</translation>
    </message>
    <message>
        <source>sbatch cannot be started: install Slurm (slurm-client), or use --write-only</source>
        <translation>sbatch lässt sich nicht starten: Installieren Sie Slurm (slurm-client) oder nehmen Sie --write-only</translation>
    </message>
    <message>
        <source>Submits the tasks as a job array, and the joining after it.</source>
        <translation>Gibt die Aufgaben als Job-Array ab, und danach das Zusammenfügen.</translation>
    </message>
    <message>
        <source>Cores of each task (default 2).</source>
        <translation>Kerne jeder Aufgabe (Vorgabe 2).</translation>
    </message>
    <message>
        <source>Writes the scripts, and submits nothing.</source>
        <translation>Schreibt die Skripte und gibt nichts ab.</translation>
    </message>
    <message>
        <source>--cpus %1: give a whole number, at least 1</source>
        <translation>--cpus %1: Geben Sie eine ganze Zahl an, mindestens 1</translation>
    </message>
    <message>
        <source>job %1: %2 tasks; job %3 joins what they draw</source>
        <translation>Job %1: %2 Aufgaben; Job %3 fügt zusammen, was sie zeichnen</translation>
    </message>
    <message>
        <source>Prints a job template of the Open Job Description.</source>
        <translation>Gibt eine Job-Vorlage der Open Job Description aus.</translation>
    </message>
    <message>
        <source>Prints a job type of Flamenco 3 for its folder of scripts.</source>
        <translation>Gibt einen Job-Typ von Flamenco 3 für dessen Skriptordner aus.</translation>
    </message>
    <message>
        <source>%1: the plan is damaged, or of another version; make it anew</source>
        <translation>%1: Der Plan ist beschädigt oder von einer anderen Version; machen Sie ihn neu</translation>
    </message>
    <message>
        <source>the plan is damaged; make it anew</source>
        <translation>der Plan ist beschädigt; machen Sie ihn neu</translation>
    </message>
    <message>
        <source>%1: there is another plan already. Remove the folder, or choose another one.</source>
        <translation>%1: Hier liegt schon ein anderer Plan. Entfernen Sie den Ordner oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made. Choose another one, or change its permissions.</source>
        <translation>%1: Der Ordner lässt sich nicht anlegen. Wählen Sie einen anderen oder ändern Sie seine Rechte.</translation>
    </message>
    <message>
        <source>%1: there is something else already. Remove it, or choose another name.</source>
        <translation>%1: Hier liegt schon etwas anderes. Entfernen Sie es oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: there is no plan (%2). Is the shared folder there? farm plan makes one.</source>
        <translation>%1: Hier ist kein Plan (%2). Ist der gemeinsame Ordner da? farm plan macht einen.</translation>
    </message>
    <message>
        <source>%1: the folder is gone. Is the shared folder there?</source>
        <translation>%1: Der Ordner ist verschwunden. Ist der gemeinsame Ordner da?</translation>
    </message>
    <message>
        <source>The folder of the farm, which all machines share.</source>
        <translation>Der Ordner der Farm, den alle Rechner gemeinsam haben.</translation>
    </message>
    <message>
        <source>Frames of the paintings being painted: name%05d.png; of several, %s is the painting&apos;s name.</source>
        <translation>Bilder vom Entstehen der Gemälde: name%05d.png; bei mehreren ist %s der Name des Gemäldes.</translation>
    </message>
    <message>
        <source>Tiles of a Deep Zoom: jpg or png.</source>
        <translation>Kacheln eines Deep Zoom: jpg oder png.</translation>
    </message>
    <message>
        <source>8 or 16 bits (default 8).</source>
        <translation>8 oder 16 Bit (Vorgabe 8).</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100.</source>
        <translation>Von JPEG und WebP, 1 bis 100.</translation>
    </message>
    <message>
        <source>a farm draws numbered frames, name%05d.png</source>
        <translation>eine Farm zeichnet nummerierte Bilder, name%05d.png</translation>
    </message>
    <message>
        <source>Plans the drawing of paintings by many machines.</source>
        <translation>Plant das Zeichnen von Gemälden durch viele Rechner.</translation>
    </message>
    <message>
        <source>-o FOLDER is missing: name the folder that all machines share</source>
        <translation>-o ORDNER fehlt: Nennen Sie den Ordner, den alle Rechner gemeinsam haben</translation>
    </message>
    <message>
        <source>give --tiles or --frames</source>
        <translation>geben Sie --tiles oder --frames an</translation>
    </message>
    <message>
        <source>several paintings need several names: put %s where the painting&apos;s name is to stand, as in out/%s.dzi</source>
        <translation>mehrere Gemälde brauchen mehrere Namen: Setzen Sie %s dorthin, wo der Name des Gemäldes stehen soll, wie in out/%s.dzi</translation>
    </message>
    <message>
        <source>%1: two paintings would become the same file. Rename one.</source>
        <translation>%1: Zwei Gemälde würden dieselbe Datei. Benennen Sie eines um.</translation>
    </message>
    <message>
        <source>--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8</source>
        <translation>--task %1: Geben Sie i/n an, z. B. 3/8, von 1/8 bis 8/8</translation>
    </message>
    <message>
        <source>the plan is for %1 &quot;%2&quot;, and this machine has &quot;%3&quot;, which makes other bits. Use the same program on all machines, or make a new plan</source>
        <translation>der Plan ist für %1 „%2“, und dieser Rechner hat „%3“, was andere Bits ergibt. Nehmen Sie auf allen Rechnern dasselbe Programm oder machen Sie einen neuen Plan</translation>
    </message>
    <message>
        <source>%1: the painting has changed since it was planned. Bring it back, or make a new plan.</source>
        <translation>%1: Das Gemälde hat sich seit der Planung geändert. Stellen Sie es wieder her oder machen Sie einen neuen Plan.</translation>
    </message>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start the task again.</source>
        <translation>%1 Was ein anderes Backend zeichnet, hat andere Bits und wird nicht beigemischt. Starten Sie die Aufgabe noch einmal.</translation>
    </message>
    <message>
        <source>Draws what is missing of a task; as often as is liked.</source>
        <translation>Zeichnet, was von einer Aufgabe fehlt; beliebig oft.</translation>
    </message>
    <message>
        <source>Which part: i/n, from 1/n to n/n (default 1/1).</source>
        <translation>Welcher Teil: i/n, von 1/n bis n/n (Vorgabe 1/1).</translation>
    </message>
    <message>
        <source>stopped; what is finished is kept, and the same command goes on</source>
        <translation>angehalten; was fertig ist, bleibt, und derselbe Befehl macht weiter</translation>
    </message>
    <message>
        <source>task %1: %2 drawn, %3 there already</source>
        <translation>Aufgabe %1: %2 gezeichnet, %3 schon da</translation>
    </message>
    <message>
        <source>let many machines draw pictures in tiles, and films</source>
        <translation>viele Rechner Bilder in Kacheln und Filme zeichnen lassen</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a smaller --size, --scale or --area</source>
        <translation>ein Bild von %1 × %2 Pixeln ist zu groß: höchstens %3 je Seite. Wählen Sie kleinere Werte für --size, --scale oder --area</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: ist ein Ordner. Geben Sie einen Dateinamen an.</translation>
    </message>
    <message>
        <source>A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a folder; --format jpg or png.</source>
        <translation>Ein Bild beliebiger Größe in Kacheln: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) oder ein Ordner; --format jpg oder png.</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side (default 254; TIFF 512).</source>
        <translation>Mit --tiles: Pixel je Seite (Vorgabe 254; TIFF 512).</translation>
    </message>
    <message>
        <source>With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0).</source>
        <translation>Mit --tiles: Pixel, die Kacheln von ihren Nachbarn zeigen (Vorgabe 1; TIFF 0).</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192).</source>
        <translation>Mit --tiles: Pixel je Seite, die auf einmal gezeichnet werden (Vorgabe 2048; CUDA 8192).</translation>
    </message>
    <message>
        <source>--%1 is not for --tiles</source>
        <translation>--%1 ist nicht für --tiles</translation>
    </message>
    <message>
        <source>--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder</source>
        <translation>--tiles %1: Der Name fehlt: Geben Sie wall.dzi, wall.tif oder einen Ordner an</translation>
    </message>
    <message>
        <source>--tiles %1: give a name that ends in .dzi or .tif, or a folder</source>
        <translation>--tiles %1: Geben Sie einen Namen an, der auf .dzi oder .tif endet, oder einen Ordner</translation>
    </message>
    <message>
        <source>--format is for Deep Zoom: the tiles of a TIFF are packed in it</source>
        <translation>--format ist für Deep Zoom: Die Kacheln eines TIFF sind darin gepackt</translation>
    </message>
    <message>
        <source>--format %1: tiles of a Deep Zoom are jpg or png</source>
        <translation>--format %1: Kacheln eines Deep Zoom sind jpg oder png</translation>
    </message>
    <message>
        <source>--depth %1: tiles have 8 or 16 bits</source>
        <translation>--depth %1: Kacheln haben 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif</source>
        <translation>Kacheln in JPEG haben 8 Bit und keine Transparenz: Nehmen Sie --format png oder .tif</translation>
    </message>
    <message>
        <source>tiles of a TIFF do not overlap, and have sides of a multiple of 16</source>
        <translation>Kacheln eines TIFF überlappen nicht, und ihre Seiten sind Vielfache von 16</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1: %2 Stücke von %n Gemälde</numerusform>
            <numerusform>%1: %2 Stücke von %n Gemälden</numerusform>
        </translation>
    </message>
    <message>
        <source>these are more than %1 pieces. Choose a greater --sheet, a smaller picture, or several plans.</source>
        <translation>das sind mehr als %1 Stücke. Wählen Sie ein größeres --sheet, ein kleineres Bild oder mehrere Pläne.</translation>
    </message>
    <message>
        <source>other machines cannot read this standard input: give files</source>
        <translation>andere Rechner können diese Standardeingabe nicht lesen: Geben Sie Dateien an</translation>
    </message>
    <message>
        <source>auto (default: a GPU where there is one), cpu or cuda.</source>
        <translation>auto (Vorgabe: eine GPU, wo es eine gibt), cpu oder cuda.</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu or cuda</source>
        <translation>--backend %1: geben Sie auto, cpu oder cuda an</translation>
    </message>
    <message>
        <source>the GPU failed (%1); the CPU went on</source>
        <translation>die GPU ist ausgefallen (%1); der Prozessor hat weitergemacht</translation>
    </message>
    <message>
        <source>stopped before it came nearer than %1; nothing was written</source>
        <translation>angehalten, bevor es näher kam als %1; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>--error %1 was not reached: it is %2. Give more --strokes or --iterations.</source>
        <translation>--error %1 wurde nicht erreicht: es ist %2. Geben Sie mehr --strokes oder --iterations an.</translation>
    </message>
    <message>
        <source>%1: is damaged</source>
        <translation>%1: ist beschädigt</translation>
    </message>
    <message>
        <source>%1: is missing</source>
        <translation>%1: fehlt</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>%n weitere Datei fehlt oder ist beschädigt; farm verify --json nennt alle.</numerusform>
            <numerusform>%n weitere Dateien fehlen oder sind beschädigt; farm verify --json nennt alle.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1: %n Zeile dieses Journals ist beschädigt, daher ist nicht bekannt, was fertig war. Führen Sie die Aufgaben noch einmal aus: Sie zeichnen, was fehlt.</numerusform>
            <numerusform>%1: %n Zeilen dieses Journals sind beschädigt, daher ist nicht bekannt, was fertig war. Führen Sie die Aufgaben noch einmal aus: Sie zeichnen, was fehlt.</numerusform>
        </translation>
    </message>
    <message>
        <source>the new strokes are farther from %1 than those before: %2 of 255, and before it was %3. Give more --strokes or --iterations.</source>
        <translation>Die neuen Striche sind weiter von %1 entfernt als die vorigen: %2 von 255, zuvor waren es %3. Geben Sie mehr --strokes oder --iterations an.</translation>
    </message>
    <message>
        <source>%1 cannot be used</source>
        <translation>%1 ist nicht zu gebrauchen</translation>
    </message>
    <message>
        <source>Lists the extensions that there are.</source>
        <translation>Zählt die Erweiterungen auf, die es gibt.</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1: there is no such extension. See suffuse-cli extension list.</source>
        <translation>%1: Eine solche Erweiterung gibt es nicht. Siehe suffuse-cli extension list.</translation>
    </message>
    <message>
        <source>--set %1: give FIELD=VALUE with one of the fields %2</source>
        <translation>--set %1: Geben Sie FIELD=VALUE an, mit einem der Felder %2</translation>
    </message>
    <message>
        <source>%1; give it by --set</source>
        <translation>%1; geben Sie es mit --set an</translation>
    </message>
    <message>
        <source>Runs an extension on a painting, and writes what it makes of it.</source>
        <translation>Wendet eine Erweiterung auf ein Bild an und schreibt, was sie daraus macht.</translation>
    </message>
    <message>
        <source>A field&apos;s value; may be given several times.</source>
        <translation>Der Wert eines Felds; darf mehrmals angegeben werden.</translation>
    </message>
    <message>
        <source>The strokes that are selected, by their ids, such as 3,7,20-180.</source>
        <translation>Die ausgewählten Striche nach ihren Nummern, etwa 3,7,20-180.</translation>
    </message>
    <message>
        <source>The group that is painted on, by its name.</source>
        <translation>Die Gruppe, in der gemalt wird, nach ihrem Namen.</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the file to write</source>
        <translation>-o OUT fehlt: Nennen Sie die Datei, die geschrieben werden soll</translation>
    </message>
    <message>
        <source>%1 makes no painting; leave -o away</source>
        <translation>%1 macht kein Bild; lassen Sie -o weg</translation>
    </message>
    <message>
        <source>%1: end the name with .suffuse or .json</source>
        <translation>%1: Der Name muss auf .suffuse oder .json enden</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli extension COMMAND [options] …</source>
        <translation>Aufruf: suffuse-cli extension BEFEHL [Optionen] …</translation>
    </message>
    <message>
        <source>the extensions that there are, with their fields</source>
        <translation>die Erweiterungen, die es gibt, mit ihren Feldern</translation>
    </message>
    <message>
        <source>run one on a painting, and write what it makes of it</source>
        <translation>eine auf ein Bild anwenden und schreiben, was sie daraus macht</translation>
    </message>
    <message>
        <source>extension %1: there is no such command. See suffuse-cli extension --help.</source>
        <translation>extension %1: Einen solchen Befehl gibt es nicht. Siehe suffuse-cli extension --help.</translation>
    </message>
    <message>
        <source>run programs of others on a painting</source>
        <translation>Programme anderer auf ein Bild anwenden</translation>
    </message>
    <message>
        <source>Its id, as extension list names it, or the path of its folder.</source>
        <translation>Ihre Kennung, wie extension list sie nennt, oder der Pfad ihres Ordners.</translation>
    </message>
    <message>
        <source>%1: it belongs to the farm in %2, and two farms would overwrite each other&apos;s pieces. Choose another name, or, if that farm is not wanted any more, remove its folder.</source>
        <translation>%1: Gehört zur Farm in %2, und zwei Farmen würden einander die Stücke überschreiben. Wählen Sie einen anderen Namen oder entfernen Sie, wenn jene Farm nicht mehr gewünscht ist, ihren Ordner.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is another farm being planned?</source>
        <translation>%1: lässt sich nicht schreiben (%2). Wird gerade eine andere Farm geplant?</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>There are no paths in the SVG of the clipboard.</source>
        <translation>Das SVG der Zwischenablage enthält keine Pfade.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>%Ln Strich kann dort, so weit außen, nicht liegen und wurde weggelassen.</numerusform>
            <numerusform>%Ln Striche können dort, so weit außen, nicht liegen und wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>Im SVG für andere Programme fehlt, was weich radiert wurde: %n Radierung.</numerusform>
            <numerusform>Im SVG für andere Programme fehlt, was weich radiert wurde: %n Radierungen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG kennt keine Gruppen, die maskieren, was darunter liegt, es löschen oder sich darauf beschränken: %n Gruppe wurde gewöhnlich.</numerusform>
            <numerusform>SVG kennt keine Gruppen, die maskieren, was darunter liegt, es löschen oder sich darauf beschränken: %n Gruppen wurden gewöhnlich.</numerusform>
        </translation>
    </message>
    <message>
        <source>An erasure is not copied without the paint that it takes away. Duplicate doubles it within its stroke, Delete removes it.</source>
        <translation>Eine Radierung wird nicht ohne die Farbe kopiert, die sie wegnimmt. „Duplizieren“ verdoppelt sie in ihrem Strich, „Löschen“ entfernt sie.</translation>
    </message>
    <message>
        <source>What was pasted lies outside of what is seen of the canvas. View ▸ Zoom to Selection goes there.</source>
        <translation>Das Eingefügte liegt außerhalb dessen, was von der Leinwand zu sehen ist. „Ansicht ▸ Auswahl einpassen“ führt dorthin.</translation>
    </message>
    <message>
        <source>There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.</source>
        <translation>Dort wäre es nicht zu sehen: Das Eingefügte liegt in der Mitte dessen, was von der Leinwand zu sehen ist.</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG kennt keine Lavierungen: Die Striche von %n Gruppe liegen dort übereinander.</numerusform>
            <numerusform>SVG kennt keine Lavierungen: Die Striche von %n Gruppen liegen dort übereinander.</numerusform>
        </translation>
    </message>
    <message>
        <source>The clipboard holds no strokes, no SVG paths, no picture and no colour.</source>
        <translation>Die Zwischenablage enthält keine Striche, keine SVG-Pfade, kein Bild und keine Farbe.</translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>Als SVG, für andere Programme, fehlt ein Bild.</numerusform>
            <numerusform>Als SVG, für andere Programme, fehlen %n Bilder.</numerusform>
        </translation>
    </message>
    <message>
        <source>What came was painted after the moment that you look at. It was brought back to this moment, so that you see it.</source>
        <translation>Was dazukam, wurde nach dem Augenblick gemalt, den Sie ansehen. Es wurde auf diesen Augenblick zurückgeholt, damit Sie es sehen.</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Delete segments</source>
        <translation>Segmente löschen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln Segment gelöscht; Rückgängig bringt es zurück.</numerusform>
            <numerusform>%Ln Segmente gelöscht; Rückgängig bringt sie zurück.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1: %Ln Strich; Rückgängig nimmt es zurück.</numerusform>
            <numerusform>%1: %Ln Striche; Rückgängig nimmt es zurück.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln Strich gelöscht; Rückgängig bringt ihn zurück.</numerusform>
            <numerusform>%Ln Striche gelöscht; Rückgängig bringt sie zurück.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Striche löschen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>The erasure is there twice now, and takes twice: drag the copy, or move it with the arrow keys.</source>
        <translation>Die Radierung ist jetzt doppelt da und nimmt zweimal weg: Ziehen Sie die Kopie, oder verschieben Sie sie mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Anheben</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Absenken</translation>
    </message>
    <message>
        <source>Raise to top</source>
        <translation>Nach ganz oben</translation>
    </message>
    <message>
        <source>Lower to bottom</source>
        <translation>Nach ganz unten</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>Horizontal spiegeln</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>Vertikal spiegeln</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>Um 90° drehen</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppieren</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Striche sperren</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Striche ausblenden</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Alle entsperren</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle einblenden</translation>
    </message>
    <message>
        <source>Rename strokes</source>
        <translation>Striche umbenennen</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Smooth strokes</source>
        <translation>Striche glätten</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>Grow or shrink paint</source>
        <translation>Farbe verbreitern oder verschmälern</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versetzen</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>Das Ausgewählte ist gesperrt oder ausgeblendet.</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>Nichts ändert sich.</translation>
    </message>
    <message>
        <source>Apply brush</source>
        <translation>Pinsel anwenden</translation>
    </message>
    <message>
        <source>Apply form of the brush</source>
        <translation>Form des Pinsels anwenden</translation>
    </message>
    <message>
        <source>Apply colour of the brush</source>
        <translation>Farbe des Pinsels anwenden</translation>
    </message>
    <message>
        <source>Apply texture of the brush</source>
        <translation>Textur des Pinsels anwenden</translation>
    </message>
    <message>
        <source>No appearance was copied.</source>
        <translation>Es wurde kein Aussehen kopiert.</translation>
    </message>
    <message>
        <source>Paste appearance</source>
        <translation>Aussehen einfügen</translation>
    </message>
    <message>
        <source>Combine strokes</source>
        <translation>Striche kombinieren</translation>
    </message>
    <message>
        <source>Break apart</source>
        <translation>Zerlegen</translation>
    </message>
    <message>
        <source>Remove erasures</source>
        <translation>Radierungen entfernen</translation>
    </message>
    <message>
        <source>Recolour artwork</source>
        <translation>Bild umfärben</translation>
    </message>
    <message>
        <source>The painting has no swatches yet.</source>
        <translation>Das Bild hat noch keine Farbfelder.</translation>
    </message>
    <message>
        <source>Map colours to swatches</source>
        <translation>Farben auf Farbfelder abbilden</translation>
    </message>
    <message>
        <source>Not combined: one stroke has one fill, and these differ, overlap, or are missing in some strokes.</source>
        <translation>Nicht kombiniert: Ein Strich hat eine Füllung, und diese sind verschieden, überlappen sich oder fehlen bei einigen Strichen.</translation>
    </message>
    <message>
        <source>Aligning takes two strokes or groups that are not locked. A group counts as one; it can be aligned relative to the canvas.</source>
        <translation>Zum Ausrichten braucht es zwei Striche oder Gruppen, die nicht gesperrt sind. Eine Gruppe zählt als eins; sie kann an der Leinwand ausgerichtet werden.</translation>
    </message>
    <message>
        <source>Distributing takes three strokes or groups that are not locked. A group counts as one.</source>
        <translation>Zum Verteilen braucht es drei Striche oder Gruppen, die nicht gesperrt sind. Eine Gruppe zählt als eins.</translation>
    </message>
    <message>
        <source>Clip group to what lies below</source>
        <translation>Gruppe auf Unteres begrenzen</translation>
    </message>
    <message>
        <source>Clip group no more</source>
        <translation>Gruppe nicht mehr begrenzen</translation>
    </message>
    <message>
        <source>Use group as mask</source>
        <translation>Gruppe als Maske verwenden</translation>
    </message>
    <message>
        <source>Use group as mask no more</source>
        <translation>Gruppe nicht mehr als Maske verwenden</translation>
    </message>
    <message>
        <source>Make group a wash</source>
        <translation>Gruppe zur Lavierung machen</translation>
    </message>
    <message>
        <source>Make wash a plain group</source>
        <translation>Lavierung zur einfachen Gruppe machen</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Ebene löschen</translation>
    </message>
    <message>
        <source>Make group a draft</source>
        <translation>Gruppe zum Entwurf machen</translation>
    </message>
    <message>
        <source>Export draft again</source>
        <translation>Entwurf wieder exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>Jetzt %Ln Strich. Wo sich Farbe berührt, mischt sie sich und addiert sich nicht mehr.</numerusform>
            <numerusform>Jetzt %Ln Striche. Wo sich ihre Farbe berührt, mischt sie sich und addiert sich nicht mehr.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln Strich ausgewählt. Nochmals Entf löscht.</numerusform>
            <numerusform>%Ln Striche ausgewählt. Nochmals Entf löscht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln Segment ausgewählt. Nochmals Entf löscht.</numerusform>
            <numerusform>%Ln Segmente ausgewählt. Nochmals Entf löscht.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>The selected strokes were exported last, and nothing is selected. Select strokes, or choose Export…</source>
        <translation>Zuletzt wurden die ausgewählten Striche exportiert, und jetzt ist nichts ausgewählt. Bitte Striche auswählen oder „Exportieren …“ wählen</translation>
    </message>
    <message>
        <source>There is nothing to export. Choose Export…</source>
        <translation>Es gibt nichts zu exportieren. Bitte „Exportieren …“ wählen</translation>
    </message>
</context>
<context>
    <name>FigureWarnings</name>
    <message>
        <source>Widest at %1 s; from then on it grows narrower while it spreads.</source>
        <translation>Am breitesten nach %1 s; von da an wird der Strich schmaler, während er verläuft.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. Up to %1 is clear.</source>
        <translation>ξ2 zu groß für ξ1: Der Strich hat keinen klaren Rand und tönt alles, wohin seine Farbe reicht. Bis %1 ist er klar.</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the paint inside the dark rim vanishes.</source>
        <translation>ξ2 zu groß für ξ1: Die Farbe innerhalb des dunklen Randes verschwindet.</translation>
    </message>
    <message>
        <source>Density 0: there is no paint.</source>
        <translation>Dichte 0: Es ist keine Farbe da.</translation>
    </message>
    <message>
        <source>Opacity 0 %: nothing of it is seen.</source>
        <translation>Deckkraft 0 %: Nichts davon ist zu sehen.</translation>
    </message>
    <message>
        <source>Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.</source>
        <extracomment>%1: seconds after it was painted</extracomment>
        <translation>Verblasst nach %1 s: Danach ist nichts mehr davon zu sehen. Mehr φ oder weniger D oder Trockenzeit verhindert das.</translation>
    </message>
    <message>
        <source>Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.</source>
        <translation>Teile verblassen, der erste nach %1 s. Mehr φ oder weniger D oder Trockenzeit verhindert das.</translation>
    </message>
    <message>
        <source>Strength 0: nothing is taken away.</source>
        <translation>Stärke 0: Es wird nichts weggenommen.</translation>
    </message>
</context>
<context>
    <name>FileReplacement</name>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: kann nicht geschrieben werden (%2). Bitte einen anderen Ordner wählen oder die Rechte ändern.</translation>
    </message>
    <message>
        <source>%1: the disk is full (%2). Free some space, or choose another disk.</source>
        <translation>%1: Die Platte ist voll (%2). Bitte Platz schaffen oder eine andere wählen.</translation>
    </message>
    <message>
        <source>%1: writing failed (%2). Choose another place.</source>
        <translation>%1: Schreiben fehlgeschlagen (%2). Bitte einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: ist ein Ordner. Bitte einen Dateinamen angeben.</translation>
    </message>
    <message>
        <source>%1: is not a plain file. Choose another name.</source>
        <translation>%1: ist keine gewöhnliche Datei. Bitte einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1: the folder %2 does not exist. Create it, or choose another.</source>
        <translation>%1: Den Ordner %2 gibt es nicht. Bitte anlegen oder einen anderen wählen.</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>a film has %1 to %2 frames a second</source>
        <translation>ein Film hat %1 bis %2 Bilder je Sekunde</translation>
    </message>
    <message>
        <source>MP4 cannot hold transparency. Use WebM, WebP or frames.</source>
        <translation>MP4 kennt keine Transparenz. Bitte WebM, WebP oder Einzelbilder verwenden.</translation>
    </message>
    <message>
        <source>a video has at most %1 pixels a side</source>
        <translation>ein Video hat höchstens %1 Pixel je Seite</translation>
    </message>
    <message>
        <source>%1: cannot write into this folder. Choose another one.</source>
        <translation>%1: In diesen Ordner kann nicht geschrieben werden. Bitte einen anderen wählen.</translation>
    </message>
    <message>
        <source>frames are numbered files: give a name such as film/%05d.png, or one that ends in .webp, .webm or .mp4</source>
        <translation>Einzelbilder sind nummerierte Dateien: bitte einen Namen wie film/%05d.png angeben oder einen mit der Endung .webp, .webm oder .mp4</translation>
    </message>
    <message>
        <source>%1: ffmpeg, which makes videos, is not installed. Install it, or choose WebP or frames.</source>
        <translation>%1: ffmpeg, das Videos erzeugt, ist nicht installiert. Bitte installieren oder WebP oder Einzelbilder wählen.</translation>
    </message>
    <message>
        <source>%1: ffmpeg could not make the video (%2). Choose another format or size.</source>
        <translation>%1: ffmpeg konnte das Video nicht erzeugen (%2). Bitte ein anderes Format oder eine andere Größe wählen.</translation>
    </message>
    <message>
        <source>%1: the film could not be written (%2).</source>
        <translation>%1: Der Film konnte nicht geschrieben werden (%2).</translation>
    </message>
    <message>
        <source>%1: the film is too large for WebP. Choose another format, a smaller size or fewer frames.</source>
        <translation>%1: Der Film ist für WebP zu groß. Bitte ein anderes Format, eine kleinere Größe oder weniger Bilder wählen.</translation>
    </message>
</context>
<context>
    <name>ImageFormat</name>
    <message>
        <source>This is no image format that can be written. Use one of these endings: %1.</source>
        <translation>Dieses Bildformat kann nicht geschrieben werden. Mögliche Endungen: %1.</translation>
    </message>
    <message>
        <source>%1 cannot hold depth %2. Choose %3, or another format.</source>
        <translation>%1 kennt die Farbtiefe %2 nicht. Bitte %3 oder ein anderes Format wählen.</translation>
    </message>
    <message>
        <source>%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.</source>
        <translation>%1 kennt keine Transparenz. Bitte PNG, TIFF, EXR oder WebP verwenden oder mit Hintergrund exportieren.</translation>
    </message>
    <message>
        <source>%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.</source>
        <translation>%1 fasst 1 bis %2 Pixel je Seite, nicht %3 × %4. Bitte eine andere Größe oder ein anderes Format wählen.</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large: at most %3 million pixels can be drawn. Choose a smaller size.</source>
        <translation>Ein Bild von %1 × %2 Pixeln ist zu groß: höchstens %3 Millionen Pixel können gezeichnet werden. Bitte eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.</source>
        <translation>%1 kann kein Farbprofil enthalten. PNG, TIFF, JPEG oder WebP wählen oder in sRGB exportieren.</translation>
    </message>
</context>
<context>
    <name>ImageModule</name>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>kann nicht geladen werden (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>gehört zu einer anderen Version von Suffuse</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again, with what suffuse-cli recommends. Pictures ending in .pfm work without it</source>
        <translation>ein Teil von Suffuse, %1, %2; Suffuse bitte neu installieren, mit dem, was suffuse-cli empfiehlt. Bilder mit der Endung .pfm gehen auch ohne</translation>
    </message>
</context>
<context>
    <name>ImageReader</name>
    <message>
        <source>%1: the image declares more than %2 × %2 or %3 million pixels. Scale it down first.</source>
        <translation>%1: Das Bild gibt mehr als %2 × %2 oder %3 Millionen Pixel an. Bitte erst verkleinern.</translation>
    </message>
    <message>
        <source>%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.</source>
        <translation>%1: ist kein PNG-, JPEG-, TIFF-, EXR- oder WebP-Bild. Bitte in eines davon umwandeln.</translation>
    </message>
    <message>
        <source>%1: cannot read %2: %3.</source>
        <translation>%1: %2 kann nicht gelesen werden: %3.</translation>
    </message>
    <message>
        <source>%1: the %2 image cannot be read (%3). It may be damaged, or too large (at most %4 pixels a side, %5 million in all).</source>
        <translation>%1: Das %2-Bild kann nicht gelesen werden (%3). Es ist vielleicht beschädigt oder zu groß (höchstens %4 Pixel je Seite, %5 Millionen insgesamt).</translation>
    </message>
</context>
<context>
    <name>ImageWriter</name>
    <message>
        <source>%1: cannot write %2: %3.</source>
        <translation>%1: %2 kann nicht geschrieben werden: %3.</translation>
    </message>
    <message>
        <source>%1: writing was cancelled; nothing was changed.</source>
        <translation>%1: Das Schreiben wurde abgebrochen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1: %2 could not be written (%3). Choose another format or depth.</source>
        <translation>%1: %2 konnte nicht geschrieben werden (%3). Bitte ein anderes Format oder eine andere Farbtiefe wählen.</translation>
    </message>
    <message>
        <source>%1: the colour profile cannot be used: %2. Choose another one.</source>
        <translation>%1: Das Farbprofil kann nicht benutzt werden: %2. Ein anderes wählen.</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>there are no strokes in it</source>
        <translation>enthält keine Striche</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>Striche importieren</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Return</source>
        <extracomment>the key, as it is called on keyboards</extracomment>
        <translation>Eingabe</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Save the changes to “%1” before closing?</source>
        <translation>Änderungen an „%1“ vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>Suffuse did not come up the last times, so it has started with the usual settings. Yours are kept in %1.</source>
        <translation>Suffuse ist die letzten Male nicht hochgekommen und hat deshalb mit den üblichen Einstellungen begonnen. Ihre sind in %1 aufgehoben.</translation>
    </message>
    <message>
        <source>Leave out the quotation marks: file dialogs take them for the borders between several names.</source>
        <translation>Ohne Anführungszeichen, bitte: Dateidialoge halten sie für die Grenzen zwischen mehreren Namen.</translation>
    </message>
    <message>
        <source>“%1” is only an ending. Give a name before it.</source>
        <translation>„%1“ ist nur eine Endung. Davor gehört ein Name.</translation>
    </message>
    <message>
        <source>Nothing is lost: the painting stays open as it is.</source>
        <translation>Nichts ist verloren: Das Bild bleibt geöffnet, wie es ist.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>Ein anderes Programm hat „%1“ geändert.</translation>
    </message>
    <message>
        <source>The file stays as it is until you save.</source>
        <translation>Die Datei bleibt, wie sie ist, bis Sie speichern.</translation>
    </message>
    <message>
        <source>Overwriting gives up what the other program wrote.</source>
        <translation>Beim Überschreiben geht verloren, was das andere Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
    <message>
        <source>&amp;Keep Mine</source>
        <translation>&amp;Meine behalten</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>Reloading takes away what was painted since the last save; Undo brings it back.</source>
        <translation>Neuladen nimmt weg, was seit dem letzten Speichern gemalt wurde; Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Without saving, what has not been saved yet is lost.</source>
        <translation>Ohne Speichern geht verloren, was noch nicht gespeichert ist.</translation>
    </message>
</context>
<context>
    <name>NodeDrag</name>
    <message>
        <source>Move nodes</source>
        <translation>Knoten verschieben</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Knoten verschieben</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>Anfasser verschieben</translation>
    </message>
    <message>
        <source>Bend curve</source>
        <translation>Kurve biegen</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Radierung verschieben</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>paper image</source>
        <translation>Papierbild</translation>
    </message>
    <message>
        <source>paper image: there is none. Choose an image, or another kind of paper.</source>
        <translation>Papierbild: Es fehlt. Bitte ein Bild oder eine andere Papierart wählen.</translation>
    </message>
</context>
<context>
    <name>Papers</name>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Cold press</source>
        <translation>Kaltgepresst</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Rau</translation>
    </message>
    <message>
        <source>Rice</source>
        <translation>Reispapier</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MB: choose a smaller picture.</source>
        <translation>%1 ist größer als 64 MB: Wählen Sie ein kleineres Bild.</translation>
    </message>
</context>
<context>
    <name>ReferenceRenderer</name>
    <message>
        <source>%1 threads · double</source>
        <translation>%1 Threads · doppelt genau</translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n Thread</numerusform>
            <numerusform>%n Threads</numerusform>
        </translation>
    </message>
    <message>
        <source>The CUDA backend cannot run: %1. Use the CPU backend.</source>
        <translation>Das CUDA-Backend kann nicht laufen: %1. Bitte das CPU-Backend verwenden.</translation>
    </message>
    <message>
        <source>%1 stopped: %2. The CPU draws now.</source>
        <translation>%1 hat aufgehört: %2. Nun zeichnet die CPU.</translation>
    </message>
    <message>
        <source>the picture is too large</source>
        <translation>das Bild ist zu groß</translation>
    </message>
    <message>
        <source>this program was built without the CUDA renderer</source>
        <translation>dieses Programm wurde ohne den CUDA-Renderer gebaut</translation>
    </message>
    <message>
        <source>no NVIDIA driver, or one that is too old for this program</source>
        <translation>kein NVIDIA-Treiber, oder einer, der für dieses Programm zu alt ist</translation>
    </message>
    <message>
        <source>there is no NVIDIA GPU</source>
        <translation>es gibt keine NVIDIA-GPU</translation>
    </message>
    <message>
        <source>the NVIDIA driver does not work</source>
        <translation>der NVIDIA-Treiber funktioniert nicht</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>der Speicher reicht nicht für %1 × %2 Pixel. Bitte eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>The reference finds no gradients. Use the CPU backend.</source>
        <translation>Die Referenz findet keine Gradienten. Nehmen Sie den Prozessor (cpu).</translation>
    </message>
</context>
<context>
    <name>Retiming</name>
    <message>
        <source>Ease in time</source>
        <translation>Zeit sanft verteilen</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Zeitlich verschieben</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>Zeitlich strecken</translation>
    </message>
    <message>
        <source>%1, with its erasures</source>
        <translation>%1, mit den Radierungen</translation>
    </message>
    <message>
        <source>%1; erasures keep their time</source>
        <translation>%1; Radierungen behalten ihre Zeit</translation>
    </message>
    <message>
        <source>Later by %1 s</source>
        <translation>Verschoben um %1 s</translation>
    </message>
    <message>
        <source>Drawn in %1 s</source>
        <translation>Gezeichnet in %1 s</translation>
    </message>
    <message>
        <source>Begins at %1 % of its pace</source>
        <translation>Beginnt mit %1 % seines Tempos</translation>
    </message>
    <message>
        <source>Ends at %1 % of its pace</source>
        <translation>Endet mit %1 % seines Tempos</translation>
    </message>
</context>
<context>
    <name>SelectHints</name>
    <message>
        <source>Drag: scale. Ctrl: keep the proportions. Shift: about the centre.</source>
        <translation>Ziehen: skalieren. Strg: Seitenverhältnis erhalten. Umschalt: um die Mitte.</translation>
    </message>
    <message>
        <source>Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.</source>
        <translation>Ziehen: drehen. Strg: in Schritten von 15°. Umschalt: um die gegenüberliegende Ecke.</translation>
    </message>
    <message>
        <source>Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.</source>
        <translation>Ziehen: scheren. Strg: in Schritten von 15°. Umschalt: um die gegenüberliegende Seite.</translation>
    </message>
    <message>
        <source>Drag: move the centre of rotation. Shift+click: back into the middle.</source>
        <translation>Ziehen: Drehpunkt verschieben. Umschalt+Klick: zurück in die Mitte.</translation>
    </message>
    <message>
        <source>Shift+Alt+click: add the next stroke below, with Ctrl within its group. Shift+Alt+drag: add what the path touches.</source>
        <translation>Umschalt+Alt+Klick: nächsten Strich darunter hinzufügen, mit Strg den in seiner Gruppe. Umschalt+Alt+Ziehen: hinzufügen, was der Pfad berührt.</translation>
    </message>
    <message>
        <source>Alt+click: select the next stroke below, with Ctrl within its group. Alt+drag: select what the path touches.</source>
        <translation>Alt+Klick: nächsten Strich darunter auswählen, mit Strg den in seiner Gruppe. Alt+Ziehen: auswählen, was der Pfad berührt.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.</source>
        <translation>Strg+Umschalt+Klick: einen Strich einer Gruppe dazu oder weg. Strg+Umschalt+Ziehen: wegnehmen.</translation>
    </message>
    <message>
        <source>Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.</source>
        <translation>Strg+Klick: ein Strich einer Gruppe. Strg+Ziehen: entlang einer Achse verschieben.</translation>
    </message>
    <message>
        <source>Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.</source>
        <translation>Umschalt+Klick: hinzufügen oder wegnehmen. Umschalt+Ziehen: Umrahmtes hinzufügen; beim Verschieben: nicht einrasten.</translation>
    </message>
    <message>
        <source>Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke below.</source>
        <translation>Klick auf Farbe wählt ihren Strich. Ziehen: Rahmen, über Farbe mit Umschalt. Alt+Klick: der Strich darunter.</translation>
    </message>
    <message>
        <source>Move by %1, %2</source>
        <translation>Verschieben um %1; %2</translation>
    </message>
    <message>
        <source>Scale to %1 % × %2 %</source>
        <translation>Skalieren auf %1 % × %2 %</translation>
    </message>
    <message>
        <source>Rotate by %1</source>
        <translation>Drehen um %1</translation>
    </message>
    <message>
        <source>Skew by %1°</source>
        <translation>Scheren um %1°</translation>
    </message>
    <message>
        <source>Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one below.</source>
        <translation>Ziehen: verschieben. Noch ein Klick: drehen, scheren. Doppelklick: Werte. Umschalt+Klick: dazu. Alt+Klick: darunter.</translation>
    </message>
</context>
<context>
    <name>SvgPaths</name>
    <message>
        <source>SVG, line %1: %2</source>
        <translation>SVG, Zeile %1: %2</translation>
    </message>
</context>
<context>
    <name>TimelinePicture</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Each stroke is a bar here: from when it is painted until it is dry.</source>
        <translation>Jeder Strich ist hier ein Balken: vom Malen, bis er trocken ist.</translation>
    </message>
</context>
<context>
    <name>Underlay</name>
    <message>
        <source>%1: there is not enough memory for it.</source>
        <translation>%1: Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>UnderlayCommands</name>
    <message>
        <source>Import underlay</source>
        <translation>Vorlage importieren</translation>
    </message>
    <message>
        <source>Replace underlay</source>
        <translation>Vorlage ersetzen</translation>
    </message>
    <message>
        <source>Show underlay</source>
        <translation>Vorlage zeigen</translation>
    </message>
    <message>
        <source>Hide underlay</source>
        <translation>Vorlage verbergen</translation>
    </message>
    <message>
        <source>Change underlay opacity</source>
        <translation>Deckkraft der Vorlage ändern</translation>
    </message>
    <message>
        <source>Move underlay</source>
        <translation>Vorlage verschieben</translation>
    </message>
    <message>
        <source>Resize underlay</source>
        <translation>Größe der Vorlage ändern</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Fit underlay to the canvas</source>
        <translation>Vorlage an die Leinwand anpassen</translation>
    </message>
    <message>
        <source>Remove underlay</source>
        <translation>Vorlage entfernen</translation>
    </message>
</context>
<context>
    <name>Validate</name>
    <message>
        <source>it is earlier than the one before it; put them in order of time</source>
        <translation>liegt vor dem vorigen; bitte nach der Zeit ordnen</translation>
    </message>
    <message>
        <source>another group has the same id</source>
        <translation>eine andere Gruppe hat dieselbe Kennung</translation>
    </message>
    <message>
        <source>there is no group with this id</source>
        <translation>es gibt keine Gruppe mit dieser Kennung</translation>
    </message>
    <message>
        <source>the group would lie within itself</source>
        <translation>die Gruppe läge in sich selbst</translation>
    </message>
    <message>
        <source>the group&apos;s members do not stand together in the order</source>
        <translation>die Mitglieder der Gruppe stehen in der Reihenfolge nicht beieinander</translation>
    </message>
    <message>
        <source>there is no such style</source>
        <translation>diesen Stil gibt es nicht</translation>
    </message>
    <message>
        <source>only edge darkening has a third value</source>
        <translation>nur dunkle Ränder haben einen dritten Wert</translation>
    </message>
    <message>
        <source>there is no such mixing mode</source>
        <translation>diese Mischart gibt es nicht</translation>
    </message>
    <message>
        <source>only beta mixing has a beta</source>
        <translation>nur die Beta-Mischung hat ein Beta</translation>
    </message>
    <message>
        <source>there is no such kind of node</source>
        <translation>diese Art von Knoten gibt es nicht</translation>
    </message>
    <message>
        <source>a stroke needs at least one</source>
        <translation>ein Strich braucht mindestens eines</translation>
    </message>
    <message>
        <source>a segment that lifts cannot fade as well</source>
        <translation>ein Segment, das abhebt, kann nicht auch verblassen lassen</translation>
    </message>
    <message>
        <source>the segment does not start where the one before it ends</source>
        <translation>das Segment beginnt nicht, wo das vorige endet</translation>
    </message>
    <message>
        <source>there is no such kind of paper</source>
        <translation>diese Papierart gibt es nicht</translation>
    </message>
    <message>
        <source>the paper&apos;s image is missing</source>
        <translation>das Bild des Papiers fehlt</translation>
    </message>
    <message>
        <source>the stroke is missing</source>
        <translation>der Strich fehlt</translation>
    </message>
    <message>
        <source>another stroke has the same id</source>
        <translation>ein anderer Strich hat dieselbe Kennung</translation>
    </message>
    <message>
        <source>%1: %2 is not in %3</source>
        <translation>%1: %2 liegt nicht in %3</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>diese Art gibt es nicht</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input</source>
        <translation>eine andere Kurve hat dieselbe Kenngröße und Eingabe</translation>
    </message>
    <message>
        <source>it needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>braucht 2 bis 16 Punkte [x, y] in [0, 1], von links nach rechts</translation>
    </message>
    <message>
        <source>there is no such rule</source>
        <translation>Diese Regel gibt es nicht</translation>
    </message>
    <message>
        <source>it is the same point as from; a gradient needs two</source>
        <translation>derselbe Punkt wie from; ein Farbverlauf braucht zwei</translation>
    </message>
    <message>
        <source>there is no such grain of paper</source>
        <translation>diese Papierkörnung gibt es nicht</translation>
    </message>
    <message>
        <source>style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2</source>
        <translation>style.xi[1]: %1 ist mehr als das 2^(1/3)-Fache von xi[0], das %2 ist</translation>
    </message>
    <message>
        <source>there is no such alignment</source>
        <translation>diese Ausrichtung gibt es nicht</translation>
    </message>
    <message>
        <source>it is no valid Unicode</source>
        <translation>das ist kein gültiges Unicode</translation>
    </message>
    <message>
        <source>%1: %2 characters are more than %3</source>
        <translation>%1: %2 Zeichen sind mehr als %3</translation>
    </message>
    <message>
        <source>%1: %2 curves are more than %3</source>
        <translation>%1: %2 Kurven sind mehr als %3</translation>
    </message>
    <message>
        <source>there is no such blend mode</source>
        <translation>diesen Mischmodus gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such colour to mark groups</source>
        <translation>diese Farbe zum Markieren von Gruppen gibt es nicht</translation>
    </message>
    <message>
        <source>it needs an image, or a link with the SHA-256 of its file</source>
        <translation>braucht ein Bild, oder eine Verknüpfung mit der SHA-256 ihrer Datei</translation>
    </message>
    <message>
        <source>it is no path of a file</source>
        <translation>ist kein Pfad einer Datei</translation>
    </message>
    <message>
        <source>it has more than 67 million pixels</source>
        <translation>hat mehr als 67 Millionen Pixel</translation>
    </message>
    <message>
        <source>its corners lie on one line; a picture needs an area</source>
        <translation>seine Ecken liegen auf einer Linie; ein Bild braucht eine Fläche</translation>
    </message>
</context>
<context>
    <name>WidthHandle</name>
    <message>
        <source>Drag to set the width by the density, Shift: by the diffusion.</source>
        <translation>Ziehen ändert die Breite über die Dichte, mit Umschalt über die Diffusion.</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Breite ändern</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.</source>
        <translation>Die Bilder sind verschieden groß (%1 × %2 und %3 × %4): bitte beide in einer Größe rendern.</translation>
    </message>
</context>
<context>
    <name>suffuse::AboutDialog</name>
    <message>
        <source>About Suffuse</source>
        <translation>Über Suffuse</translation>
    </message>
    <message>
        <source>Icon of Suffuse</source>
        <translation>Symbol von Suffuse</translation>
    </message>
    <message>
        <source>Suffuse %1</source>
        <translation>Suffuse %1</translation>
    </message>
    <message>
        <source>Paints with strokes that really diffuse, and stay editable.</source>
        <translation>Malt mit Strichen, die wirklich verlaufen und bearbeitbar bleiben.</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0.</source>
        <translation>Freie Software unter der Apache-Lizenz 2.0.</translation>
    </message>
</context>
<context>
    <name>suffuse::AgePlot</name>
    <message>
        <source>No paint here</source>
        <translation>Hier ist keine Farbe</translation>
    </message>
    <message>
        <source>density φ, up to %1</source>
        <translation>Dichte φ, bis %1</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>Alter %1 s</translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message>
        <source>Along the Stroke</source>
        <translation>Entlang des Strichs</translation>
    </message>
    <message>
        <source>Curve along the stroke</source>
        <translation>Kurve entlang des Strichs</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Kenngröße</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>The same value all along</source>
        <translation>Überall derselbe Wert</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Evenly from one value to another</source>
        <translation>Gleichmäßig von einem Wert zum anderen</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>A curve drawn with the pointer</source>
        <translation>Eine mit dem Zeiger gezeichnete Kurve</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Change along the stroke</source>
        <translation>Entlang des Strichs ändern</translation>
    </message>
    <message>
        <source>Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve is drawn with the pointer. The dots are the values of the segments.</source>
        <translation>Die Linie, ihre Enden oder ihre Punkte ziehen; ein Druck daneben macht einen Punkt, Entf entfernt einen. Eine gezeichnete Kurve zeichnet man mit dem Zeiger. Die kleinen Punkte sind die Werte der Segmente.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>The values that there are, as a curve of points that can be moved</source>
        <translation>Die vorhandenen Werte als Kurve aus Punkten, die sich bewegen lassen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>Multiplies all of it; what varies along the stroke stays</source>
        <translation>Vervielfacht alles; was entlang des Strichs wechselt, bleibt</translation>
    </message>
    <message>
        <source>Is added to all of it; what varies along the stroke stays</source>
        <translation>Wird zu allem addiert; was entlang des Strichs wechselt, bleibt</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n Strich</numerusform>
            <numerusform>%n Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke – %1</source>
        <translation>Entlang des Strichs – %1</translation>
    </message>
    <message>
        <source>Nothing is selected that can be changed. Click a stroke, and its values are shown here.</source>
        <translation>Nichts ist ausgewählt, was geändert werden kann. Klicken Sie auf einen Strich, dann stehen seine Werte hier.</translation>
    </message>
</context>
<context>
    <name>suffuse::AreaRow</name>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Which part of the canvas is drawn</source>
        <translation>Welcher Teil der Leinwand gezeichnet wird</translation>
    </message>
    <message>
        <source>Whole canvas</source>
        <translation>Ganze Leinwand</translation>
    </message>
    <message>
        <source>What is painted</source>
        <translation>Was gemalt ist</translation>
    </message>
    <message>
        <source>Selected strokes</source>
        <translation>Ausgewählte Striche</translation>
    </message>
    <message>
        <source>What the window shows</source>
        <translation>Was das Fenster zeigt</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>Nach Zahlen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Linker Rand</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>Oberer Rand</translation>
    </message>
    <message>
        <source>W</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantRow</name>
    <message>
        <source>Parallel Lines</source>
        <translation>Parallele Linien</translation>
    </message>
    <message>
        <source>Vanishing Point</source>
        <translation>Fluchtpunkt</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Concentric Ellipses</source>
        <translation>Konzentrische Ellipsen</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>What is made next</source>
        <translation>Was als Nächstes entsteht</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Horizontal place of the chosen point, canvas units</source>
        <translation>Waagerechte Lage des gewählten Punktes, Leinwandeinheiten</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Vertical place of the chosen point, canvas units</source>
        <translation>Senkrechte Lage des gewählten Punktes, Leinwandeinheiten</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Angle of the line or of the first half axis, clockwise</source>
        <translation>Winkel der Linie oder der ersten Halbachse, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>First half axis of the ellipse, canvas units</source>
        <translation>Erste Halbachse der Ellipse, Leinwandeinheiten</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Second half axis of the ellipse, canvas units</source>
        <translation>Zweite Halbachse der Ellipse, Leinwandeinheiten</translation>
    </message>
    <message>
        <source>A new one in the middle of the view</source>
        <translation>Eine neue in der Mitte der Ansicht</translation>
    </message>
    <message>
        <source>New assistant</source>
        <translation>Neue Zeichenhilfe</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantTool</name>
    <message>
        <source>Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next point. Return: a new one.</source>
        <translation>Ziehen: neue Zeichenhilfe; ihre Punkte oder Linien ziehen ändert sie. Umschalt: in Schritten. Tab: nächster Punkt. Eingabe: eine neue.</translation>
    </message>
    <message>
        <source>%1, point %2 of %3: x %4, y %5</source>
        <extracomment>%1: an assistant, as &quot;Vanishing Point&quot;</extracomment>
        <translation>%1, Punkt %2 von %3: x %4, y %5</translation>
    </message>
</context>
<context>
    <name>suffuse::AttributeBrushTool</name>
    <message>
        <source>How fast it is laid down</source>
        <translation>Wie schnell aufgetragen wird</translation>
    </message>
    <message>
        <source>Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.</source>
        <translation>Ziehen über Striche malt den gewählten Wert auf ihre Segmente. [ und ] ändern die Größe.</translation>
    </message>
    <message>
        <source>Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.</source>
        <translation>Ziehen über die Auswahl malt den gewählten Wert auf ihre Segmente. [ und ] ändern die Größe.</translation>
    </message>
    <message>
        <source>Paint diffusion</source>
        <translation>Diffusion malen</translation>
    </message>
    <message>
        <source>Paint density</source>
        <translation>Dichte malen</translation>
    </message>
    <message>
        <source>Paint granulation</source>
        <translation>Granulation malen</translation>
    </message>
    <message>
        <source>Paint colour</source>
        <translation>Farbe malen</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>Deckkraft malen</translation>
    </message>
    <message>
        <source>Paint drying time</source>
        <translation>Trockenzeit malen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it is.</source>
        <translation>Eine Füllung hat eine eigene Dichte ρ, die der Inspektor zeigt. Relativ zu dem, was sie ist, kann sie gemalt werden.</translation>
    </message>
</context>
<context>
    <name>suffuse::BackupsDialog</name>
    <message>
        <source>Restore Backup</source>
        <translation>Sicherungskopie wiederherstellen</translation>
    </message>
    <message>
        <source>There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings says how many are.</source>
        <translation>Von „%1“ gibt es noch keine Sicherungskopie. Beim nächsten Speichern bleibt die Fassung davor erhalten; wie viele bleiben, steht in den Einstellungen.</translation>
    </message>
    <message>
        <source>An earlier version of “%1” takes the place of the painting as it is now. Undo brings that back, and no file changes until you save.</source>
        <translation>Eine frühere Fassung von „%1“ tritt an die Stelle des Bildes, wie es jetzt ist. Rückgängig bringt dieses zurück, und keine Datei ändert sich, bevor gespeichert wird.</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>Sicherungskopien, die neueste zuerst</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushColourPage</name>
    <message>
        <source>Second colour</source>
        <translation>Zweite Farbe</translation>
    </message>
    <message>
        <source>&amp;Take the Current Colour</source>
        <translation>A&amp;ktuelle Farbe übernehmen</translation>
    </message>
    <message>
        <source>Makes the current colour the second one</source>
        <translation>Macht die aktuelle Farbe zur zweiten</translation>
    </message>
    <message>
        <source>The row Second colour of the curves says when it comes through.</source>
        <translation>Wann sie durchkommt, bestimmt die Zeile „Zweite Farbe“ der Kurven.</translation>
    </message>
    <message>
        <source>Strays from the colour by</source>
        <translation>Weicht von der Farbe ab um</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>At most so much redder or less red</source>
        <translation>Höchstens so viel mehr oder weniger rot</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>At most so much more or less yellow</source>
        <translation>Höchstens so viel mehr oder weniger gelb</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>At most so much bluer or less blue</source>
        <translation>Höchstens so viel mehr oder weniger blau</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>At most so much lighter or darker</source>
        <translation>Höchstens so viel heller oder dunkler</translation>
    </message>
    <message>
        <source>Drifts along the stroke</source>
        <translation>Driftet entlang des Strichs</translation>
    </message>
    <message>
        <source>Else each stroke has one colour</source>
        <translation>Sonst hat jeder Strich eine Farbe</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCombo</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Pinsel suchen</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCurvesPage</name>
    <message>
        <source>Second colour</source>
        <translation>Zweite Farbe</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>By stroke</source>
        <translation>Je Strich</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>What changes with what: a tick switches a curve on, a click shows it below</source>
        <translation>Was sich womit ändert: Ein Häkchen schaltet eine Kurve ein, ein Klick zeigt sie unten</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Drag points; click for another one, drag it out to take it away</source>
        <translation>Punkte ziehen; ein Klick fügt einen hinzu, Hinausziehen entfernt ihn</translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation>Volles Tempo</translation>
    </message>
    <message>
        <source>Speed at the right end of its curves, in sizes a second</source>
        <translation>Tempo am rechten Ende seiner Kurven, in Größen je Sekunde</translation>
    </message>
    <message>
        <source> sizes/s</source>
        <translation> Gr./s</translation>
    </message>
    <message>
        <source>Full distance</source>
        <translation>Volle Strecke</translation>
    </message>
    <message>
        <source>Distance at the right end of its curves, in sizes</source>
        <translation>Strecke am rechten Ende ihrer Kurven, in Größen</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> Gr.</translation>
    </message>
    <message>
        <source>Way on which what drifts becomes another, in sizes</source>
        <translation>Weg, auf dem ein driftender Wert zu einem anderen wird, in Größen</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushDialog</name>
    <message>
        <source>A stroke of the brush</source>
        <translation>Ein Strich des Pinsels</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Farbauftrag</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Shape and hand</source>
        <translation>Form und Hand</translation>
    </message>
    <message>
        <source>Settings of the brush</source>
        <translation>Einstellungen des Pinsels</translation>
    </message>
    <message>
        <source>Keeps the changes in the brush of this name; built-in brushes stay as they are</source>
        <translation>Behält die Änderungen im Pinsel dieses Namens; mitgelieferte Pinsel bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Keeps the brush under another name</source>
        <translation>Behält den Pinsel unter einem anderen Namen</translation>
    </message>
    <message>
        <source>Closes this window; the brush stays in hand as it is</source>
        <translation>Schließt dieses Fenster; der Pinsel bleibt in der Hand, wie er ist</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pinsel: %1</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>Änderungen &amp;speichern</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Als &amp;neuen speichern …</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushGrid</name>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>%1: size %2, dry after %3</source>
        <translation>%1: Größe %2, trocken nach %3</translation>
    </message>
    <message>
        <source>Changed since the program was started; Reload in its menu undoes that</source>
        <translation>Seit dem Programmstart geändert; „Neu laden“ in seinem Menü macht das rückgängig</translation>
    </message>
    <message>
        <source>There is no such brush.</source>
        <translation>Einen solchen Pinsel gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose a brush to paint with it.</source>
        <translation>Wählen Sie einen Pinsel, um mit ihm zu malen.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushHandPage</name>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Of the tip, against the path or the canvas</source>
        <translation>Der Spitze, gegen den Weg oder die Leinwand</translation>
    </message>
    <message>
        <source>Turns with the path</source>
        <translation>Dreht sich mit dem Weg</translation>
    </message>
    <message>
        <source>Else it keeps its angle on the canvas, as a broad nib does</source>
        <translation>Sonst behält sie ihren Winkel auf der Leinwand, wie eine Breitfeder</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> Gr.</translation>
    </message>
    <message>
        <source>Taper in</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>Length on which the stroke grows from its tip</source>
        <translation>Länge, auf der der Strich aus seiner Spitze wächst</translation>
    </message>
    <message>
        <source>Taper out</source>
        <translation>Auslauf</translation>
    </message>
    <message>
        <source>Length on which it runs out when the pen lifts</source>
        <translation>Länge, auf der er ausläuft, wenn der Stift abhebt</translation>
    </message>
    <message>
        <source>Tip size</source>
        <translation>Größe der Spitze</translation>
    </message>
    <message>
        <source>Size at the very end</source>
        <translation>Größe ganz am Ende</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Beruhigt die Hand: Der Strich folgt dem Stift sanft oder wird an einer Schnur gezogen</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Time between the points that the curve is fitted through</source>
        <translation>Zeit zwischen den Punkten, durch die die Kurve gelegt wird</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushLibrary</name>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; check its permissions</source>
        <translation>%1: Der Ordner konnte nicht angelegt werden; bitte die Rechte prüfen</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; save it under a name of its own</source>
        <translation>%1 ist ein mitgelieferter Pinsel; bitte unter eigenem Namen speichern</translation>
    </message>
    <message>
        <source>A brush needs a name</source>
        <translation>Ein Pinsel braucht einen Namen</translation>
    </message>
    <message>
        <source>There is a brush “%1” already</source>
        <translation>Einen Pinsel „%1“ gibt es schon</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; it stays</source>
        <translation>%1 ist ein mitgelieferter Pinsel; er bleibt</translation>
    </message>
    <message>
        <source>%1 could not be removed; check its permissions</source>
        <translation>%1 konnte nicht entfernt werden; bitte die Rechte prüfen</translation>
    </message>
    <message>
        <source>There is no brush “%1”</source>
        <translation>Einen Pinsel „%1“ gibt es nicht</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushMenu</name>
    <message>
        <source>&amp;Edit Brush…</source>
        <translation>Pinsel &amp;bearbeiten …</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favorit</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>Änderungen &amp;speichern</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>Als &amp;neuen speichern …</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen …</translation>
    </message>
    <message>
        <source>De&amp;lete…</source>
        <translation>&amp;Löschen …</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Save Brush</source>
        <translation>Pinsel speichern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Rename Brush</source>
        <translation>Pinsel umbenennen</translation>
    </message>
    <message>
        <source>Delete the brush “%1”?</source>
        <translation>Pinsel „%1“ löschen?</translation>
    </message>
    <message>
        <source>Strokes painted with it stay.</source>
        <translation>Die mit ihm gemalten Striche bleiben.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Import Brushes</source>
        <translation>Pinsel importieren</translation>
    </message>
    <message>
        <source>Brushes (*.suffuse-brush *.myb);;All files (*)</source>
        <translation>Pinsel (*.suffuse-brush *.myb);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1: these settings have no counterpart here: %2</source>
        <translation>%1: Für diese Einstellungen gibt es hier keine Entsprechung: %2</translation>
    </message>
    <message>
        <source>Export Brush</source>
        <translation>Pinsel exportieren</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse-Pinsel</translation>
    </message>
    <message>
        <source>Rel&amp;oad</source>
        <translation>Neu l&amp;aden</translation>
    </message>
    <message>
        <source>&amp;Apply to Selection</source>
        <translation>&amp;Auf die Auswahl anwenden</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>&amp;Ganzer Pinsel</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>Nur &amp;Form</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>Nur Fa&amp;rbe</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>Nur &amp;Textur</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPaintPage</name>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Wie aus Dichte Deckung wird.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Wie sich die Farbe mit dem Darunterliegenden mischt: Sie deckt, oder Pigmente addieren sich.</translation>
    </message>
    <message>
        <source>How long the paint spreads; the size stays</source>
        <translation>Wie lange die Farbe verläuft; die Größe bleibt</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPalette</name>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the painting is shown</source>
        <translation>Wie groß das Bild gezeigt wird</translation>
    </message>
    <message>
        <source>Brush palette</source>
        <translation>Pinselpalette</translation>
    </message>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Wählen, womit gemalt wird. Die Farbe bleibt.</translation>
    </message>
    <message>
        <source>Current colour</source>
        <translation>Aktuelle Farbe</translation>
    </message>
    <message>
        <source>Near colours</source>
        <translation>Nahe Farben</translation>
    </message>
    <message>
        <source>Lighter and darker, the neighbouring hues, and from grey to full</source>
        <translation>Heller und dunkler, die benachbarten Farbtöne, und von Grau bis satt</translation>
    </message>
    <message>
        <source>Painted with last</source>
        <translation>Zuletzt gemalt</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Letzte Farben</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPanel</name>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>Womit gemalt wird. Die Farbe bleibt.</translation>
    </message>
    <message>
        <source>Reset brush</source>
        <translation>Pinsel zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the brush as it came</source>
        <translation>Zurück zum ursprünglichen Pinsel</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (geändert)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>Pinsel suchen</translation>
    </message>
    <message>
        <source>Shows brushes and groups with this in their name</source>
        <translation>Zeigt Pinsel und Gruppen, deren Name dies enthält</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>Nur Favoriten</translation>
    </message>
    <message>
        <source>Show favourites only; the first nine have the keys 1 to 9</source>
        <translation>Nur Favoriten zeigen; die ersten neun haben die Tasten 1 bis 9</translation>
    </message>
    <message>
        <source>Brush menu</source>
        <translation>Pinselmenü</translation>
    </message>
    <message>
        <source>Edit, save, import and export brushes</source>
        <translation>Pinsel bearbeiten, speichern, importieren und exportieren</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushTool</name>
    <message>
        <source>Brush stroke</source>
        <translation>Pinselstrich</translation>
    </message>
    <message>
        <source>Shift+drag to go on with the selected stroke from its end.</source>
        <translation>Umschalt+Ziehen setzt den ausgewählten Strich an seinem Ende fort.</translation>
    </message>
    <message>
        <source>Extend stroke</source>
        <translation>Strich fortsetzen</translation>
    </message>
    <message>
        <source>This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.</source>
        <translation>Dieser Strich liegt neben der Leinwand: Ansicht ▸ Farbe neben der Leinwand zeigen.</translation>
    </message>
    <message>
        <source>All that you paint stays editable: press V and click paint to move, scale or recolour it.</source>
        <translation>Alles Gemalte bleibt bearbeitbar: V, dann Farbe anklicken, um sie zu verschieben, zu skalieren oder umzufärben.</translation>
    </message>
    <message>
        <source>Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture&apos;s colour, with Shift the stroke&apos;s own.</source>
        <translation>Ziehen malt. Rechtsklick: Palette. Umschalt+Ziehen: Größe, Deckkraft. Strg+Klick: Farbe des Bildes, mit Umschalt die des Strichs.</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushToolOptions</name>
    <message>
        <source>Width of a dry line at full pressure, in units ([ and ] change it)</source>
        <translation>Breite einer trockenen Linie bei vollem Druck, in Einheiten ([ und ] ändern sie)</translation>
    </message>
    <message>
        <source>How much the paint covers ({ and } change it)</source>
        <translation>Wie stark die Farbe deckt ({ und } ändern es)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>Beruhigt die Hand: Der Strich folgt dem Stift sanft oder wird an einer Schnur gezogen</translation>
    </message>
    <message>
        <source>Amount of smoothing</source>
        <translation>Maß der Glättung</translation>
    </message>
    <message>
        <source>How strongly it lags behind, or how long the string is</source>
        <translation>Wie stark der Strich zurückbleibt oder wie lang die Schnur ist</translation>
    </message>
    <message>
        <source>Own brush</source>
        <translation>Eigener Pinsel</translation>
    </message>
    <message>
        <source>What to paint with. Click: all brushes, with pictures.</source>
        <translation>Womit gemalt wird. Klick: alle Pinsel, mit Bildern.</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasDrops</name>
    <message>
        <source>Drop colour</source>
        <translation>Farbe ablegen</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasMenu</name>
    <message>
        <source>Under the Pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>Further Below</source>
        <translation>Weiter unten</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>An&amp;ordnen</translation>
    </message>
    <message>
        <source>R&amp;eshape</source>
        <translation>Um&amp;formen</translation>
    </message>
    <message>
        <source>Dr&amp;ying</source>
        <translation>T&amp;rocknen</translation>
    </message>
    <message>
        <source>Brush and C&amp;olours</source>
        <translation>&amp;Pinsel und Farben</translation>
    </message>
    <message>
        <source>Apply &amp;Brush</source>
        <translation>Pinsel &amp;anwenden</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>Au&amp;ssehen</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>K&amp;noten</translation>
    </message>
    <message>
        <source>Trans&amp;form</source>
        <translation>Transfor&amp;mieren</translation>
    </message>
    <message>
        <source>Com&amp;bine and Break</source>
        <translation>&amp;Verbinden und zerlegen</translation>
    </message>
    <message>
        <source>Select S&amp;ame</source>
        <translation>Gleiche &amp;auswählen</translation>
    </message>
    <message>
        <source>Under&amp;lay</source>
        <translation>Vor&amp;lage</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>Far&amp;ben</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasSection</name>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Background colour. Click: white.</source>
        <translation>Hintergrundfarbe. Klick: Weiß.</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Resize canvas</source>
        <translation>Leinwandgröße ändern</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Breite der Leinwand in Einheiten; eine Einheit ist bei 100 % ein Pixel.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>Höhe der Leinwand in Einheiten; eine Einheit ist bei 100 % ein Pixel.</translation>
    </message>
    <message>
        <source>%1 × %2 mm at %3 dpi</source>
        <translation>%1 × %2 mm bei %3 dpi</translation>
    </message>
    <message>
        <source>%1 × %2 in at %3 dpi</source>
        <translation>%1 × %2 Zoll bei %3 dpi</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>Bild …</translation>
    </message>
    <message>
        <source>The paper&apos;s grain, which granulating strokes show.</source>
        <translation>Die Körnung des Papiers, die granulierende Striche zeigen.</translation>
    </message>
    <message>
        <source>Take the grain from another picture file.</source>
        <translation>Die Körnung aus einer anderen Bilddatei nehmen.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number gives another grain.</source>
        <translation>Eine andere Zahl gibt eine andere Körnung.</translation>
    </message>
    <message>
        <source>Change paper</source>
        <translation>Papier ändern</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Paper image</source>
        <translation>Papierbild</translation>
    </message>
    <message>
        <source>%1 cannot be used as paper: %2</source>
        <translation>%1 kann nicht als Papier dienen: %2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Size of the coarsest grain or of a thread in units, or units per pixel of the image.</source>
        <translation>Größe des gröbsten Korns oder eines Fadens in Einheiten, oder Einheiten je Bildpixel.</translation>
    </message>
    <message>
        <source>Choose &amp;Image…</source>
        <translation>B&amp;ild wählen …</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasWidget</name>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>The picture goes to the screen by way of memory: %1</source>
        <translation>Das Bild nimmt den Weg über den Hauptspeicher: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourChips</name>
    <message>
        <source>%1, opacity %2 %</source>
        <translation>%1, Deckkraft %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourHeader</name>
    <message>
        <source>Shows and changes the colour that is painted with</source>
        <translation>Zeigt und ändert die Farbe, mit der gemalt wird</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>Farbe des Ausgewählten</translation>
    </message>
    <message>
        <source>Shows and changes the colour of what is selected; it keeps its opacity</source>
        <translation>Zeigt und ändert die Farbe des Ausgewählten; es behält seine Deckkraft</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Several colours</source>
        <translation>Mehrere Farben</translation>
    </message>
    <message>
        <source>Set: all colours become the same.
Shift: all change as the shown one does, and keep their differences.</source>
        <translation>Setzen: Alle Farben werden gleich.
Versatz: Alle ändern sich wie die gezeigte und behalten ihre Unterschiede.</translation>
    </message>
    <message>
        <source>Apply to selection</source>
        <translation>Auf Auswahl anwenden</translation>
    </message>
    <message>
        <source>Apply to selection: gives the selected segments the brush&apos;s colour. They keep their opacity.</source>
        <translation>Auf Auswahl anwenden: gibt den ausgewählten Segmenten die Farbe des Pinsels. Sie behalten ihre Deckkraft.</translation>
    </message>
    <message>
        <source>Apply colour</source>
        <translation>Farbe anwenden</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Farbe des Pinsels</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPanel</name>
    <message>
        <source>Current colour</source>
        <translation>Aktuelle Farbe</translation>
    </message>
    <message>
        <source>The colour that is painted with</source>
        <translation>Die Farbe, mit der gemalt wird</translation>
    </message>
    <message>
        <source>Previous colour</source>
        <translation>Vorherige Farbe</translation>
    </message>
    <message>
        <source>The colour painted with last. Click: back to it.</source>
        <translation>Die zuletzt gemalte Farbe. Klick: zurück zu ihr.</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB-Farbe als #rrggbb, #rgb oder wie in CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>„%1“ ist keine Farbe. Schreibweise: #rrggbb, zum Beispiel #2f6690.</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>Letzte Farben</translation>
    </message>
    <message>
        <source>Colours painted with before. Click: take it.</source>
        <translation>Früher gemalte Farben. Klick: übernehmen.</translation>
    </message>
    <message>
        <source>Colours painted with come here.</source>
        <translation>Hierher kommen die gemalten Farben.</translation>
    </message>
    <message>
        <source>RYB</source>
        <extracomment>red, yellow, blue; hue, saturation, value; red, green, blue</extracomment>
        <translation>RYB</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>The numbers that the sliders show: paint as red, yellow and blue, or the screen&apos;s hue, saturation and value, or its red, green and blue</source>
        <translation>Die Zahlen, die die Regler zeigen: Farbe als Rot, Gelb und Blau, oder Farbton, Sättigung und Hellwert des Bildschirms, oder dessen Rot, Grün und Blau</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>Farbe des Pinsels</translation>
    </message>
    <message>
        <source>The colour of the brush. Click: take it.</source>
        <translation>Die Farbe des Pinsels. Klick: diese nehmen.</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message>
        <source>Colour of the brush</source>
        <translation>Farbe des Pinsels</translation>
    </message>
    <message>
        <source>Colour of a swatch</source>
        <translation>Farbe eines Farbfelds</translation>
    </message>
    <message>
        <source>Colour of the swatch “%1”</source>
        <translation>Farbe des Farbfelds „%1“</translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>Farben von %Ln Segment</numerusform>
            <numerusform>Farben von %Ln Segmenten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>Farbe von %Ln Segment</numerusform>
            <numerusform>Farbe von %Ln Segmenten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>Farben von %Ln Strich</numerusform>
            <numerusform>Farben von %Ln Strichen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>Farbe von %Ln Strich</numerusform>
            <numerusform>Farbe von %Ln Strichen</numerusform>
        </translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Change swatch</source>
        <translation>Farbfeld ändern</translation>
    </message>
    <message>
        <source>Colour of the fill</source>
        <translation>Farbe der Füllung</translation>
    </message>
    <message>
        <source>Colours of the fill</source>
        <translation>Farben der Füllung</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s end</source>
        <translation>Farbe am Ende des Farbverlaufs</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s start</source>
        <translation>Farbe am Anfang des Farbverlaufs</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>Farbkreis</translation>
    </message>
    <message>
        <source>Ring: hue in the order of pigments. Triangle: pure, white and black.
Arrow keys work too.</source>
        <translation>Ring: Farbton in der Ordnung der Pigmente. Dreieck: rein, weiß und schwarz.
Auch die Pfeiltasten wirken.</translation>
    </message>
</context>
<context>
    <name>suffuse::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Commands, brushes, docks, recent files</source>
        <translation>Befehle, Pinsel, Andockfenster, zuletzt geöffnete Dateien</translation>
    </message>
    <message>
        <source>Parts of names in any order; Enter runs the chosen one, Escape goes back.</source>
        <translation>Teile von Namen in beliebiger Reihenfolge; die Eingabetaste führt das Gewählte aus, Escape kehrt zurück.</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Click one to run it.</source>
        <translation>Ein Klick führt den Befehl aus.</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>Nichts heißt so.</translation>
    </message>
    <message>
        <source>It cannot be used now.</source>
        <translation>Das ist gerade nicht möglich.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>“%1” cannot be used now.</source>
        <translation>„%1“ ist gerade nicht möglich.</translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Neu …</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>Fenster s&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>D&amp;eselect</source>
        <translation>Auswahl auf&amp;heben</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Settin&amp;gs…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>Paint strokes</source>
        <translation>Striche malen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswahl</translation>
    </message>
    <message>
        <source>Select and move strokes</source>
        <translation>Striche auswählen und verschieben</translation>
    </message>
    <message>
        <source>Se&amp;gments</source>
        <translation>&amp;Segmente</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>&amp;Hand</translation>
    </message>
    <message>
        <source>Move the canvas</source>
        <translation>Leinwand verschieben</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>&amp;Anheben</translation>
    </message>
    <message>
        <source>&amp;Lower</source>
        <translation>A&amp;bsenken</translation>
    </message>
    <message>
        <source>Raise to &amp;Top</source>
        <translation>&amp;Nach ganz oben</translation>
    </message>
    <message>
        <source>Lower to &amp;Bottom</source>
        <translation>Nach ganz &amp;unten</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit the Canvas</source>
        <translation>Leinwand &amp;einpassen</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>&amp;Aufrecht</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>&amp;Spiegeln</translation>
    </message>
    <message>
        <source>&amp;Hide the Docks</source>
        <translation>Andockfenster aus&amp;blenden</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Anordn&amp;ung zurücksetzen</translation>
    </message>
    <message>
        <source>Docks and tool bars go back to where they stand at the first start</source>
        <translation>Andockfenster und Werkzeugleisten kehren dorthin zurück, wo sie beim ersten Start stehen</translation>
    </message>
    <message>
        <source>Full S&amp;creen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>&amp;Tastenkürzel …</translation>
    </message>
    <message>
        <source>&amp;About Suffuse…</source>
        <translation>&amp;Über Suffuse …</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>An&amp;dockfenster</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Aus&amp;schneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Ein&amp;fügen</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>An &amp;Originalposition einfügen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Paste strokes where they were</source>
        <translation>Striche dort einfügen, wo sie waren</translation>
    </message>
    <message>
        <source>Edit segments, nodes and handles of strokes</source>
        <translation>Segmente, Knoten und Anfasser von Strichen bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>&amp;Messer</translation>
    </message>
    <message>
        <source>Cut strokes along a line</source>
        <translation>Striche entlang einer Linie zerschneiden</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Radierer</translation>
    </message>
    <message>
        <source>&amp;Attribute Brush</source>
        <translation>A&amp;ttributpinsel</translation>
    </message>
    <message>
        <source>Paint values onto segments</source>
        <translation>Werte auf Segmente malen</translation>
    </message>
    <message>
        <source>Eye&amp;dropper</source>
        <translation>&amp;Farbpipette</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>Farbe aufnehmen</translation>
    </message>
    <message>
        <source>&amp;Insert Nodes</source>
        <translation>&amp;Knoten einfügen</translation>
    </message>
    <message>
        <source>Insert a node into each selected segment</source>
        <translation>In jedes ausgewählte Segment einen Knoten einfügen</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>&amp;Eckig</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Make the selected nodes corners</source>
        <translation>Die ausgewählten Knoten eckig machen</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glatt</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Make the selected nodes smooth</source>
        <translation>Die ausgewählten Knoten glatt machen</translation>
    </message>
    <message>
        <source>S&amp;ymmetric</source>
        <translation>&amp;Symmetrisch</translation>
    </message>
    <message>
        <source>Shift+Y</source>
        <translation>Shift+Y</translation>
    </message>
    <message>
        <source>Make the selected nodes symmetric</source>
        <translation>Die ausgewählten Knoten symmetrisch machen</translation>
    </message>
    <message>
        <source>&amp;Break Strokes</source>
        <translation>Striche &amp;auftrennen</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Break strokes at the selected nodes</source>
        <translation>Striche an den ausgewählten Knoten auftrennen</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>Knoten &amp;verbinden</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Join two selected end nodes</source>
        <translation>Zwei ausgewählte Endknoten verbinden</translation>
    </message>
    <message>
        <source>&amp;Delete Segments</source>
        <translation>Segmente &amp;löschen</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Brid&amp;ge Segments</source>
        <translation>Segmente ü&amp;berbrücken</translation>
    </message>
    <message>
        <source>Alt+Del</source>
        <translation>Alt+Del</translation>
    </message>
    <message>
        <source>Replace selected segments by one that goes on smoothly</source>
        <translation>Ausgewählte Segmente durch eines ersetzen, das glatt weiterläuft</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>Richtung &amp;umkehren</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>Let the selected strokes run from end to start</source>
        <translation>Die ausgewählten Striche vom Ende zum Anfang laufen lassen</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objekt</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Knoten</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>Auswahl &amp;umkehren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>!</source>
        <translation>!</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>Select all strokes of the same colour</source>
        <translation>Alle Striche derselben Farbe auswählen</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>&amp;Stil</translation>
    </message>
    <message>
        <source>Select all strokes of the same style</source>
        <translation>Alle Striche desselben Stils auswählen</translation>
    </message>
    <message>
        <source>Select all strokes of the same brush</source>
        <translation>Alle Striche desselben Pinsels auswählen</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Select what is drawn around; with Shift from paint, too</source>
        <translation>Auswählen, was umfahren wird; mit Umschalt auch von Farbe aus</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>&amp;Berühren</translation>
    </message>
    <message>
        <source>Select what a path touches</source>
        <translation>Auswählen, was ein Pfad berührt</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppieren</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Gruppierung auf&amp;heben</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>Alle &amp;entsperren</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ausb&amp;lenden</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>Alle e&amp;inblenden</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>U&amp;mbenennen …</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Flip Hori&amp;zontally</source>
        <translation>Hori&amp;zontal spiegeln</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>&amp;Vertikal spiegeln</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Rotate by &amp;90° Left</source>
        <translation>Um 90° nach lin&amp;ks drehen</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate by 90° R&amp;ight</source>
        <translation>Um &amp;90° nach rechts drehen</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>&amp;Scale Spread with the Shape</source>
        <translation>Ausbreitung mit &amp;der Form skalieren</translation>
    </message>
    <message>
        <source>Spread and density follow the shape when it is scaled</source>
        <translation>Ausbreitung und Dichte folgen der Form, wenn sie skaliert wird</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>&amp;Linke Kanten</translation>
    </message>
    <message>
        <source>&amp;Centres, Horizontally</source>
        <translation>&amp;Horizontal zentrieren</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>&amp;Rechte Kanten</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>&amp;Obere Kanten</translation>
    </message>
    <message>
        <source>&amp;Middles, Vertically</source>
        <translation>&amp;Vertikal zentrieren</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>&amp;Untere Kanten</translation>
    </message>
    <message>
        <source>Relative to the &amp;Selection</source>
        <translation>Relativ zur &amp;Auswahl</translation>
    </message>
    <message>
        <source>Relative to the C&amp;anvas</source>
        <translation>Relativ zur Lein&amp;wand</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Horizontally</source>
        <translation>Gleiche Abstände, &amp;horizontal</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Vertically</source>
        <translation>Gleiche Abstände, &amp;vertikal</translation>
    </message>
    <message>
        <source>Even &amp;Centres, Horizontally</source>
        <translation>Gleiche &amp;Mittenabstände, horizontal</translation>
    </message>
    <message>
        <source>Even C&amp;entres, Vertically</source>
        <translation>Gleiche Mittena&amp;bstände, vertikal</translation>
    </message>
    <message>
        <source>Snap to &amp;Nodes</source>
        <translation>An K&amp;noten einrasten</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>Am Gi&amp;tter einrasten</translation>
    </message>
    <message>
        <source>&amp;Show the Grid</source>
        <translation>Gitter an&amp;zeigen</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Grid St&amp;ep…</source>
        <translation>Gitter&amp;weite …</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Ausri&amp;chten</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Ver&amp;teilen</translation>
    </message>
    <message>
        <source>Select Sa&amp;me</source>
        <translation>&amp;Gleiche auswählen</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Ti&amp;me</source>
        <translation>&amp;Zeit</translation>
    </message>
    <message>
        <source>&amp;Favourite Brushes</source>
        <translation>Pinselfav&amp;oriten</translation>
    </message>
    <message>
        <source>Favourite Brush %1</source>
        <translation>Pinselfavorit %1</translation>
    </message>
    <message>
        <source>Relative to the &amp;First Selected</source>
        <translation>Relativ zum zu&amp;erst Ausgewählten</translation>
    </message>
    <message>
        <source>Relative to the Bi&amp;ggest</source>
        <translation>Relativ zum &amp;Größten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play the painting being painted, or pause</source>
        <translation>Das Entstehen des Bildes abspielen oder anhalten</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>&amp;Zum Anfang</translation>
    </message>
    <message>
        <source>Shift+,</source>
        <translation>Shift+,</translation>
    </message>
    <message>
        <source>Go to where the painting begins</source>
        <translation>Dorthin gehen, wo das Bild beginnt</translation>
    </message>
    <message>
        <source>P&amp;revious Stroke</source>
        <translation>&amp;Voriger Strich</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Go back to where a stroke begins</source>
        <translation>Zurück zum Beginn eines Strichs</translation>
    </message>
    <message>
        <source>&amp;Next Stroke</source>
        <translation>&amp;Nächster Strich</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Go on to where a stroke begins</source>
        <translation>Weiter zum Beginn eines Strichs</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Shift+.</source>
        <translation>Shift+.</translation>
    </message>
    <message>
        <source>Go to the end, where all has dried: the present</source>
        <translation>Zum Ende gehen, wo alles getrocknet ist: in die Gegenwart</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Schleife</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>Immer wieder abspielen</translation>
    </message>
    <message>
        <source>S&amp;kip Pauses</source>
        <translation>&amp;Pausen überspringen</translation>
    </message>
    <message>
        <source>Cut pauses in which nothing is painted or spreads to half a second</source>
        <translation>Pausen, in denen nichts gemalt wird oder verläuft, auf eine halbe Sekunde kürzen</translation>
    </message>
    <message>
        <source>Preview When &amp;Dry</source>
        <translation>Vorschau ge&amp;trocknet</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Show wet paint as it will look when it has dried, while you paint too</source>
        <translation>Nasse Farbe so zeigen, wie sie getrocknet aussehen wird, auch während Sie malen</translation>
    </message>
    <message>
        <source>Let It Dr&amp;y</source>
        <translation>T&amp;rocknen lassen</translation>
    </message>
    <message>
        <source>Go to the moment at which all has dried</source>
        <translation>Zu dem Zeitpunkt gehen, an dem alles getrocknet ist</translation>
    </message>
    <message>
        <source>&amp;Freeze Wet Paint</source>
        <translation>Nasse Farbe ein&amp;frieren</translation>
    </message>
    <message>
        <source>Ctrl+Alt+F</source>
        <translation>Ctrl+Alt+F</translation>
    </message>
    <message>
        <source>All that is wet stops spreading at this moment</source>
        <translation>Alles Nasse verläuft ab diesem Zeitpunkt nicht weiter</translation>
    </message>
    <message>
        <source>Re-&amp;wet…</source>
        <translation>&amp;Wieder anfeuchten …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Let the selected paint spread on for a while from this moment</source>
        <translation>Die ausgewählte Farbe ab diesem Zeitpunkt eine Weile weiter verlaufen lassen</translation>
    </message>
    <message>
        <source>Remove Re-we&amp;tting</source>
        <translation>Wiederanfeuchten auf&amp;heben</translation>
    </message>
    <message>
        <source>The selected paint dries once and for all</source>
        <translation>Die ausgewählte Farbe trocknet ein für alle Mal</translation>
    </message>
    <message>
        <source>&amp;Even</source>
        <translation>&amp;Gleichmäßig</translation>
    </message>
    <message>
        <source>Selected strokes are drawn at an even pace</source>
        <translation>Ausgewählte Striche werden gleichmäßig schnell gezeichnet</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>Sanfter &amp;Anfang</translation>
    </message>
    <message>
        <source>Selected strokes begin slowly</source>
        <translation>Ausgewählte Striche beginnen langsam</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>Sanftes &amp;Ende</translation>
    </message>
    <message>
        <source>Selected strokes end slowly</source>
        <translation>Ausgewählte Striche enden langsam</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Anfang und Ende &amp;sanft</translation>
    </message>
    <message>
        <source>Selected strokes begin and end slowly</source>
        <translation>Ausgewählte Striche beginnen und enden langsam</translation>
    </message>
    <message>
        <source>Export Ti&amp;melapse…</source>
        <translation>Zeitr&amp;affer exportieren …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Make a film of the painting being painted</source>
        <translation>Das Entstehen des Bildes als Film ausgeben</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>Zei&amp;chentempo</translation>
    </message>
    <message>
        <source>Relative to the Last Select&amp;ed</source>
        <translation>Relativ zum &amp;zuletzt Ausgewählten</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File</source>
        <translation>Rückgängig-Sc&amp;hritte in der Datei behalten</translation>
    </message>
    <message>
        <source>Whoever opens the file can go on undoing. Take it out before you give a file away</source>
        <translation>Wer die Datei öffnet, kann weiter rückgängig machen. Bitte ausschalten, bevor Sie die Datei weitergeben</translation>
    </message>
    <message>
        <source>Import &amp;Underlay…</source>
        <translation>Vor&amp;lage importieren …</translation>
    </message>
    <message>
        <source>A picture to paint over, which shows on the canvas only</source>
        <translation>Ein Bild zum Übermalen, das sich nur auf der Leinwand zeigt</translation>
    </message>
    <message>
        <source>Show the Underl&amp;ay</source>
        <translation>Vorlage ze&amp;igen</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>&amp;Import Strokes…</source>
        <translation>Striche &amp;importieren …</translation>
    </message>
    <message>
        <source>Drawings, recordings and the strokes of other paintings, into this one</source>
        <translation>Zeichnungen, Aufnahmen und Striche anderer Bilder, in dieses Bild</translation>
    </message>
    <message>
        <source>S&amp;maller Tool Size</source>
        <translation>Werkzeug &amp;verkleinern</translation>
    </message>
    <message>
        <source>La&amp;rger Tool Size</source>
        <translation>Werkzeug ver&amp;größern</translation>
    </message>
    <message>
        <source>&amp;Less Opacity</source>
        <translation>&amp;Weniger Deckkraft</translation>
    </message>
    <message>
        <source>More &amp;Opacity</source>
        <translation>Mehr &amp;Deckkraft</translation>
    </message>
    <message>
        <source>Move the Canvas While Held</source>
        <translation>Leinwand verschieben, solange gehalten</translation>
    </message>
    <message>
        <source>Turn the Canvas While Held</source>
        <translation>Leinwand drehen, solange gehalten</translation>
    </message>
    <message>
        <source>Move the Selection</source>
        <translation>Auswahl verschieben</translation>
    </message>
    <message>
        <source>Move the Selection Ten Times as Far</source>
        <translation>Auswahl zehnmal so weit verschieben</translation>
    </message>
    <message>
        <source>Move the Selection by One Unit</source>
        <translation>Auswahl um eine Einheit verschieben</translation>
    </message>
    <message>
        <source>Move the Selection by Ten Units</source>
        <translation>Auswahl um zehn Einheiten verschieben</translation>
    </message>
    <message>
        <source>Move Rows in the Strokes Dock</source>
        <translation>Zeilen im Dock „Striche“ verschieben</translation>
    </message>
    <message>
        <source>Previous Stroke or Node</source>
        <translation>Voriger Strich oder Knoten</translation>
    </message>
    <message>
        <source>Give Up, or Deselect</source>
        <translation>Abbrechen oder Auswahl aufheben</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>&amp;Kopie speichern …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+S</source>
        <translation>Ctrl+Alt+Shift+S</translation>
    </message>
    <message>
        <source>Into another file; you go on painting in this one</source>
        <translation>In eine andere Datei; gemalt wird in dieser weiter</translation>
    </message>
    <message>
        <source>Re&amp;vert…</source>
        <translation>Zurück zur Da&amp;tei …</translation>
    </message>
    <message>
        <source>Back to what the file holds; Undo takes it back</source>
        <translation>Zurück zu dem, was in der Datei steht; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>Sicherungskopie wie&amp;derherstellen …</translation>
    </message>
    <message>
        <source>Back to an earlier version of the file</source>
        <translation>Zurück zu einer früheren Fassung der Datei</translation>
    </message>
    <message>
        <source>Export A&amp;gain</source>
        <translation>Erneut exp&amp;ortieren</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>To the same file, with the same settings</source>
        <translation>In dieselbe Datei, mit denselben Einstellungen</translation>
    </message>
    <message>
        <source>Hide Outlines and Handles While Held</source>
        <translation>Konturen und Griffe ausblenden, solange gehalten</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Select all strokes of the same name</source>
        <translation>Alle Striche mit demselben Namen auswählen</translation>
    </message>
    <message>
        <source>Select &amp;Found</source>
        <translation>Gefu&amp;ndenes auswählen</translation>
    </message>
    <message>
        <source>Select what the search in the Strokes dock has found</source>
        <translation>Auswählen, was die Suche im Andockfenster „Striche“ gefunden hat</translation>
    </message>
    <message>
        <source>Find Strokes</source>
        <translation>Striche suchen</translation>
    </message>
    <message>
        <source>Look for strokes and groups by their names, in the Strokes dock</source>
        <translation>Striche und Gruppen nach ihren Namen suchen, im Dock „Striche“</translation>
    </message>
    <message>
        <source>Show Ou&amp;tlines</source>
        <translation>K&amp;onturen zeigen</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Lines along the selected strokes; the Brush shows none</source>
        <translation>Linien entlang der ausgewählten Striche; der Pinsel zeigt keine</translation>
    </message>
    <message>
        <source>Show Paint &amp;beyond the Canvas</source>
        <translation>&amp;Farbe neben der Leinwand zeigen</translation>
    </message>
    <message>
        <source>Under a veil, what was painted beside the canvas; it is in no picture that is exported</source>
        <translation>Unter einem Schleier, was neben die Leinwand gemalt wurde; in exportierten Bildern ist es nie</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>Näc&amp;hster Bereich</translation>
    </message>
    <message>
        <source>The keyboard goes from the canvas to the docks and tool bars in turn</source>
        <translation>Die Tastatur geht von der Leinwand reihum zu den Bereichen und Werkzeugleisten</translation>
    </message>
    <message>
        <source>&amp;Previous Panel</source>
        <translation>Voriger Berei&amp;ch</translation>
    </message>
    <message>
        <source>The keyboard goes back from panel to panel</source>
        <translation>Die Tastatur geht von Bereich zu Bereich zurück</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Befehl suchen …</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Commands, brushes, docks and recent files by their names</source>
        <translation>Befehle, Pinsel, Andockfenster und zuletzt geöffnete Dateien nach ihrem Namen</translation>
    </message>
    <message>
        <source>Drawing pace</source>
        <translation>Zeichentempo</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Wiederanfeuchten aufheben</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Weite</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File (%1)</source>
        <translation>Rückgängig-Sc&amp;hritte in der Datei behalten (%1)</translation>
    </message>
    <message>
        <source>Canvas, while held</source>
        <translation>Leinwand, solange gehalten</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Canvas, Strokes dock</source>
        <translation>Leinwand, Dock „Striche“</translation>
    </message>
    <message>
        <source>Canvas, Timeline dock</source>
        <translation>Leinwand, Dock „Zeitleiste“</translation>
    </message>
    <message>
        <source>Canvas, Segments tool</source>
        <translation>Leinwand, Segmente</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Nothing is wet at this moment.</source>
        <translation>Zu diesem Zeitpunkt ist nichts nass.</translation>
    </message>
    <message>
        <source>Freeze wet paint</source>
        <translation>Nasse Farbe einfrieren</translation>
    </message>
    <message>
        <source>Nothing that is selected is painted yet at this moment.</source>
        <translation>Zu diesem Zeitpunkt ist noch nichts vom Ausgewählten gemalt.</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>Name der Gruppe</translation>
    </message>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>Name von %Ln Strich</numerusform>
            <numerusform>Name von %Ln Strichen</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Re-wet</source>
        <translation>Wieder anfeuchten</translation>
    </message>
    <message>
        <source>Seconds that the paint spreads on</source>
        <translation>Sekunden, die die Farbe weiter verläuft</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Smooth the curves of the selected strokes; each time more</source>
        <translation>Glättet die Kurven der gewählten Striche, jedes Mal mehr</translation>
    </message>
    <message>
        <source>S&amp;traighten</source>
        <translation>&amp;Begradigen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Move the selected strokes towards straight lines; each time more</source>
        <translation>Zieht die gewählten Striche zur Geraden hin, jedes Mal mehr</translation>
    </message>
    <message>
        <source>&amp;Grow Paint</source>
        <translation>Farbe &amp;verbreitern</translation>
    </message>
    <message>
        <source>Ctrl+)</source>
        <translation>Ctrl+)</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes wider</source>
        <translation>Macht die Farbe der gewählten Striche breiter</translation>
    </message>
    <message>
        <source>S&amp;hrink Paint</source>
        <translation>Farbe ver&amp;schmälern</translation>
    </message>
    <message>
        <source>Ctrl+(</source>
        <translation>Ctrl+(</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes narrower</source>
        <translation>Macht die Farbe der gewählten Striche schmaler</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>Das Ausgewählte ist gesperrt oder ausgeblendet.</translation>
    </message>
    <message>
        <source>Simp&amp;lify…</source>
        <translation>Verein&amp;fachen…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Make fewer segments of the selected strokes</source>
        <translation>Macht weniger Segmente aus den gewählten Strichen</translation>
    </message>
    <message>
        <source>&amp;Offset and More…</source>
        <translation>Verset&amp;zen und mehr…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Offset, smooth, straighten, grow or shrink the selected strokes by numbers</source>
        <translation>Versetzt, glättet, begradigt, verbreitert oder verschmälert die gewählten Striche nach Zahlen</translation>
    </message>
    <message>
        <source>Resha&amp;pe</source>
        <translation>Um&amp;formen</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Wet what the selected strokes enclose; the inspector has its values</source>
        <translation>Nässt, was die gewählten Striche umschließen; der Inspektor hat die Werte</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Remove Fill</source>
        <translation>Füllung entfernen</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Füllung entfernen</translation>
    </message>
    <message>
        <source>Leave of the selected strokes their outlines</source>
        <translation>Lässt von den gewählten Strichen die Umrisse</translation>
    </message>
    <message>
        <source>Geome&amp;tric Shapes</source>
        <translation>Geometris&amp;che Formen</translation>
    </message>
    <message>
        <source>Paint rectangles, ellipses, polygons and stars</source>
        <translation>Malt Rechtecke, Ellipsen, Vielecke und Sterne</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>Neu &amp;zeichnen</translation>
    </message>
    <message>
        <source>Draw over a part of a stroke, which follows the new line</source>
        <translation>Zeichnet über einen Teil eines Strichs, der der neuen Linie folgt</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>Sch&amp;ieben</translation>
    </message>
    <message>
        <source>Push, comb, pinch or roughen strokes</source>
        <translation>Schiebt, kämmt, rafft oder raut Striche auf</translation>
    </message>
    <message>
        <source>What lies under the pointer, and what can be done with it</source>
        <translation>Was unter dem Zeiger liegt, und was damit getan werden kann</translation>
    </message>
    <message>
        <source>Br&amp;ush Palette at the Pointer</source>
        <translation>Pinselpa&amp;lette am Zeiger</translation>
    </message>
    <message>
        <source>Brushes, colours, size and zoom where the pointer is</source>
        <translation>Pinsel, Farben, Größe und Zoom dort, wo der Zeiger ist</translation>
    </message>
    <message>
        <source>Edit Value&amp;s Here…</source>
        <translation>Wer&amp;te hier bearbeiten …</translation>
    </message>
    <message>
        <source>Width, diffusion, density, colour and opacity of what is selected, at the pointer</source>
        <translation>Breite, Diffusion, Dichte, Farbe und Deckkraft des Ausgewählten, am Zeiger</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>&amp;Ganzer Pinsel</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Put the brush in hand on the selected strokes; they remember the pen&apos;s pressure</source>
        <translation>Gibt den gewählten Strichen den Pinsel in der Hand; sie erinnern sich an den Druck des Stifts</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>Nur &amp;Form</translation>
    </message>
    <message>
        <source>Width, density, tapering and tip of the brush in hand</source>
        <translation>Breite, Dichte, Verjüngung und Spitze des Pinsels in der Hand</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>Nur Fa&amp;rbe</translation>
    </message>
    <message>
        <source>Colour and opacity of the brush in hand</source>
        <translation>Farbe und Deckkraft des Pinsels in der Hand</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>Nur &amp;Textur</translation>
    </message>
    <message>
        <source>Style, mixing, grain and drying time of the brush in hand</source>
        <translation>Stil, Mischung, Körnung und Trockenzeit des Pinsels in der Hand</translation>
    </message>
    <message>
        <source>C&amp;opy Appearance</source>
        <translation>Aussehen ko&amp;pieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy style, mixing, values and colour of the stroke that was selected last</source>
        <translation>Kopiert Stil, Mischung, Werte und Farbe des zuletzt gewählten Strichs</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Put it on the selected strokes; what varies along them goes on varying</source>
        <translation>Gibt es den gewählten Strichen; was entlang ihrer wechselt, wechselt weiterhin</translation>
    </message>
    <message>
        <source>Paste Appearance Evenl&amp;y</source>
        <translation>Aussehen gle&amp;ichmäßig einfügen</translation>
    </message>
    <message>
        <source>Put it on the selected strokes, with the same values all along</source>
        <translation>Gibt es den gewählten Strichen, mit denselben Werten von Anfang bis Ende</translation>
    </message>
    <message>
        <source>Along th&amp;e Stroke…</source>
        <translation>Entlang des St&amp;richs …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Set a value along the stroke: constant, as a ramp, or drawn as a curve</source>
        <translation>Setzt einen Wert entlang des Strichs: konstant, als Rampe oder als gezeichnete Kurve</translation>
    </message>
    <message>
        <source>Vary at Rand&amp;om…</source>
        <translation>Zufällig ab&amp;wandeln …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Y</source>
        <translation>Ctrl+Alt+Y</translation>
    </message>
    <message>
        <source>Let values and colours of the selected strokes stray at random</source>
        <translation>Lässt Werte und Farben der gewählten Striche zufällig abweichen</translation>
    </message>
    <message>
        <source>Appl&amp;y Brush</source>
        <translation>&amp;Pinsel anwenden</translation>
    </message>
    <message>
        <source>Show Erasures</source>
        <translation>Radierungen zeigen</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Umschalt+E</translation>
    </message>
    <message>
        <source>Dashed lines along what was erased softly from all strokes; what is not selected is paler</source>
        <translation>Gestrichelte Linien entlang dem, was aus allen Strichen weich radiert wurde; nicht Ausgewähltes ist blasser</translation>
    </message>
    <message>
        <source>&amp;Combine</source>
        <translation>K&amp;ombinieren</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Strg+Alt+K</translation>
    </message>
    <message>
        <source>Make one stroke of the selected ones, whose paint adds up</source>
        <translation>Macht aus den ausgewählten Strichen einen, dessen Farbe sich addiert</translation>
    </message>
    <message>
        <source>Break Apart</source>
        <translation>Zerlegen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Strg+Umschalt+K</translation>
    </message>
    <message>
        <source>Make strokes of the parts of the selected ones</source>
        <translation>Macht aus den Teilen der ausgewählten Striche eigene Striche</translation>
    </message>
    <message>
        <source>Remove Erasures</source>
        <translation>Radierungen entfernen</translation>
    </message>
    <message>
        <source>Bring back what was erased softly from the selected strokes, or by the selected segments</source>
        <translation>Bringt zurück, was von den ausgewählten Strichen oder durch die ausgewählten Segmente weich radiert wurde</translation>
    </message>
    <message>
        <source>Delete the selected segments, which leaves gaps in strokes</source>
        <translation>Löscht die ausgewählten Segmente; in Strichen bleiben Lücken</translation>
    </message>
    <message>
        <source>Take paint away softly, or cut out parts of strokes</source>
        <translation>Farbe weich wegnehmen oder Teile von Strichen herausschneiden</translation>
    </message>
    <message>
        <source>Map Colours to S&amp;watches</source>
        <translation>Far&amp;ben auf Farbfelder abbilden</translation>
    </message>
    <message>
        <source>Give what is selected, or else all of the painting, the swatches that look nearest</source>
        <translation>Dem Ausgewählten, sonst dem ganzen Bild, die Farbfelder geben, die am ähnlichsten aussehen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Give each colour of the painting, or of what is selected, another one everywhere</source>
        <translation>Jeder Farbe des Bildes oder des Ausgewählten überall eine andere geben</translation>
    </message>
    <message>
        <source>Paste Appeara&amp;nce</source>
        <translation>Aussehen einf&amp;ügen</translation>
    </message>
    <message>
        <source>Menu at t&amp;he Pointer</source>
        <translation>Menü am &amp;Zeiger</translation>
    </message>
    <message>
        <source>Recolour Artwor&amp;k…</source>
        <translation>Bild umf&amp;ärben …</translation>
    </message>
    <message>
        <source>Match &amp;by Eyedropper</source>
        <translation>&amp;Mit Farbpipette angleichen</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its style, mixing, values and colour</source>
        <translation>Einen Strich anklicken: Die ausgewählten bekommen seinen Stil, seine Mischung, seine Werte und seine Farbe</translation>
    </message>
    <message>
        <source>A fill cannot be wetted again. It spreads as long as it takes to dry.</source>
        <translation>Eine Füllung kann nicht noch einmal befeuchtet werden. Sie breitet sich aus, so lange sie trocknet.</translation>
    </message>
    <message>
        <source>Not done: nothing would be left.</source>
        <translation>Nicht ausgeführt: Es bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>Not done: the outlines meet so often that it would take minutes.</source>
        <translation>Nicht ausgeführt: Die Umrisse treffen sich so oft, dass es Minuten dauern würde.</translation>
    </message>
    <message>
        <source>Not done: the outlines lie on each other so closely that the result is uncertain.</source>
        <translation>Nicht ausgeführt: Die Umrisse liegen so eng aufeinander, dass das Ergebnis unsicher ist.</translation>
    </message>
    <message>
        <source>Select two or more filled strokes.</source>
        <translation>Wählen Sie zwei oder mehr gefüllte Striche.</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Vereinigung</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>One fill of what the selected ones cover, with the values of the lowest</source>
        <translation>Eine Füllung aus allem, was die ausgewählten bedecken, mit den Werten der untersten</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Differenz</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what the others do not cover</source>
        <translation>Lässt von der untersten ausgewählten Füllung, was die anderen nicht bedecken</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>&amp;Überschneidung</translation>
    </message>
    <message>
        <source>Ctrl+*</source>
        <translation>Ctrl+*</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what all others cover</source>
        <translation>Lässt von der untersten ausgewählten Füllung, was alle anderen bedecken</translation>
    </message>
    <message>
        <source>E&amp;xclusion</source>
        <translation>E&amp;xklusion</translation>
    </message>
    <message>
        <source>Ctrl+^</source>
        <translation>Ctrl+^</translation>
    </message>
    <message>
        <source>One fill of what one of the selected ones covers, and not two</source>
        <translation>Eine Füllung aus dem, was eine der ausgewählten bedeckt und nicht zwei</translation>
    </message>
    <message>
        <source>Di&amp;vision</source>
        <translation>Divisio&amp;n</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Cut the lowest selected fill along the outlines of the others</source>
        <translation>Schneidet die unterste ausgewählte Füllung an den Umrissen der anderen</translation>
    </message>
    <message>
        <source>Select a filled stroke.</source>
        <translation>Wählen Sie einen gefüllten Strich.</translation>
    </message>
    <message>
        <source>I&amp;nset</source>
        <translation>&amp;Schrumpfen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+(</source>
        <translation>Ctrl+Alt+(</translation>
    </message>
    <message>
        <source>Move the outlines of fills inwards, by the distance of Offset and More</source>
        <translation>Schiebt die Umrisse von Füllungen nach innen, um den Abstand von „Versetzen und mehr“</translation>
    </message>
    <message>
        <source>&amp;Outset</source>
        <translation>&amp;Erweitern</translation>
    </message>
    <message>
        <source>Ctrl+Alt+)</source>
        <translation>Ctrl+Alt+)</translation>
    </message>
    <message>
        <source>Move the outlines of fills outwards, by the distance of Offset and More</source>
        <translation>Schiebt die Umrisse von Füllungen nach außen, um den Abstand von „Versetzen und mehr“</translation>
    </message>
    <message>
        <source>&amp;Stroke to Outline</source>
        <translation>Strich in &amp;Umriss umwandeln</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Make fills of what is seen of the lines of the selected strokes</source>
        <translation>Macht Füllungen aus dem, was von den Linien der ausgewählten Striche zu sehen ist</translation>
    </message>
    <message>
        <source>Stroke to outline</source>
        <translation>Strich in Umriss umwandeln</translation>
    </message>
    <message>
        <source>Select a stroke of which a line is seen.</source>
        <translation>Wählen Sie einen Strich, von dem eine Linie zu sehen ist.</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Flächen verrechnen</translation>
    </message>
    <message>
        <source>Outline Pe&amp;n</source>
        <translation>&amp;Umriss-Zeichenfeder</translation>
    </message>
    <message>
        <source>Draw an outline node by node, filled or not</source>
        <translation>Einen Umriss Knoten für Knoten zeichnen, gefüllt oder nicht</translation>
    </message>
    <message>
        <source>Lasso F&amp;ill</source>
        <translation>Lasso-Füllu&amp;ng</translation>
    </message>
    <message>
        <source>Fill what is drawn around</source>
        <translation>Füllen, was umfahren wird</translation>
    </message>
    <message>
        <source>Bu&amp;cket</source>
        <translation>Far&amp;beimer</translation>
    </message>
    <message>
        <source>Fill what the paint around a place bounds</source>
        <translation>Füllen, was die Farbe um eine Stelle begrenzt</translation>
    </message>
    <message>
        <source>Text to Strokes</source>
        <translation>Text in Striche umwandeln</translation>
    </message>
    <message>
        <source>Make plain strokes of the letters of the selected texts; they cannot be typed in any more</source>
        <translation>Aus den Buchstaben der gewählten Texte gewöhnliche Striche machen; in sie lässt sich dann nicht mehr schreiben</translation>
    </message>
    <message>
        <source>Text to strokes</source>
        <translation>Text in Striche</translation>
    </message>
    <message>
        <source>Release Text from Stroke</source>
        <translation>Text vom Strich lösen</translation>
    </message>
    <message>
        <source>Let the selected texts keep their curves, whatever becomes of the strokes that they follow</source>
        <translation>Die gewählten Texte behalten ihre Kurven, was auch immer aus den Strichen wird, denen sie folgen</translation>
    </message>
    <message>
        <source>Select a text that follows a stroke.</source>
        <translation>Wählen Sie einen Text aus, der einem Strich folgt.</translation>
    </message>
    <message>
        <source>Release text from stroke</source>
        <translation>Text vom Strich lösen</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>Te&amp;xt</translation>
    </message>
    <message>
        <source>Type texts, whose letters are strokes</source>
        <translation>Texte schreiben, deren Buchstaben Striche sind</translation>
    </message>
    <message>
        <source>&amp;Zoom to Selection</source>
        <translation>Auswahl ein&amp;passen</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Show what is selected as large as possible: strokes, segments or nodes</source>
        <translation>Zeigt so groß wie möglich, was ausgewählt ist: Striche, Segmente oder Knoten</translation>
    </message>
    <message>
        <source>Add Gradient</source>
        <translation>Farbverlauf hinzufügen</translation>
    </message>
    <message>
        <source>The colour of the selected fills fades from left to right; needs a fill of one colour</source>
        <translation>Die Farbe der ausgewählten Füllungen verläuft von links nach rechts; nötig ist eine einfarbige Füllung</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Farbverlauf hinzufügen</translation>
    </message>
    <message>
        <source>Remove Gradient</source>
        <translation>Farbverlauf entfernen</translation>
    </message>
    <message>
        <source>The selected fills have their first colour everywhere; needs a fill with a gradient</source>
        <translation>Die ausgewählten Füllungen haben überall ihre erste Farbe; nötig ist eine Füllung mit Farbverlauf</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Farbverlauf entfernen</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Auf Unteres begrenzen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>The selected groups are seen only where the next thing below them in the same group is; needs something below</source>
        <translation>Die ausgewählten Gruppen sind nur dort zu sehen, wo in derselben Gruppe das Nächste unter ihnen ist; braucht etwas darunter</translation>
    </message>
    <message>
        <source>Use as Mask</source>
        <translation>Als Maske verwenden</translation>
    </message>
    <message>
        <source>What is beside the selected groups is seen only where they have paint; needs something beside</source>
        <translation>Was neben den ausgewählten Gruppen ist, ist nur dort zu sehen, wo sie Farbe haben; braucht etwas daneben</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Lavierung</translation>
    </message>
    <message>
        <source>The strokes of the selected groups are one, laid wet into wet</source>
        <translation>Die Striche der ausgewählten Gruppen sind je einer, nass in nass aufgetragen</translation>
    </message>
    <message>
        <source>What the group did as a whole (opacity, mode, isolation, clip, mask, wash) is gone with it.</source>
        <translation>Was die Gruppe als Ganzes tat (Deckkraft, Modus, eigene Mischung, Begrenzung, Maske, Lavierung), ist mit ihr verschwunden.</translation>
    </message>
    <message>
        <source>Group as a Whole</source>
        <translation>Gruppe als Ganzes</translation>
    </message>
    <message>
        <source>Not merged: nothing lies below the layer in its group.</source>
        <translation>Nicht vereint: In ihrer Gruppe liegt nichts unter der Ebene.</translation>
    </message>
    <message>
        <source>Not merged: what lies just below the layer is no layer.</source>
        <translation>Nicht vereint: Was direkt unter der Ebene liegt, ist keine Ebene.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is hidden.</source>
        <translation>Nicht vereint: Eine der beiden Ebenen ist ausgeblendet.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is locked.</source>
        <translation>Nicht vereint: Eine der beiden Ebenen ist gesperrt.</translation>
    </message>
    <message>
        <source>Merge layer down</source>
        <translation>Ebene nach unten vereinen</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>Ebene anheben</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>Ebene absenken</translation>
    </message>
    <message>
        <source>&amp;New Layer</source>
        <translation>&amp;Neue Ebene</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paint on a new layer above this one; it comes with its first stroke</source>
        <translation>Auf einer neuen Ebene über dieser malen; sie entsteht mit ihrem ersten Strich</translation>
    </message>
    <message>
        <source>New &amp;Clipped Layer</source>
        <translation>Neue be&amp;grenzte Ebene</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Paint on a new layer that shows only where the layer below has paint: a clipping mask</source>
        <translation>Auf einer neuen Ebene malen, die nur zu sehen ist, wo die Ebene darunter Farbe hat: eine Schnittmaske</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>Ebene &amp;duplizieren</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>&amp;Mit darunterliegender vereinen</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Raise Layer</source>
        <translation>Ebene an&amp;heben</translation>
    </message>
    <message>
        <source>&amp;Lower Layer</source>
        <translation>Ebene a&amp;bsenken</translation>
    </message>
    <message>
        <source>Layer &amp;Above</source>
        <translation>Ebene da&amp;rüber</translation>
    </message>
    <message>
        <source>Paint on the next layer above; above all of them there is none</source>
        <translation>Auf der nächsthöheren Ebene malen; über allen ist keine</translation>
    </message>
    <message>
        <source>Layer &amp;Below</source>
        <translation>Ebene dar&amp;unter</translation>
    </message>
    <message>
        <source>Paint on the next layer below</source>
        <translation>Auf der nächsttieferen Ebene malen</translation>
    </message>
    <message>
        <source>N&amp;o Layer</source>
        <translation>&amp;Keine Ebene</translation>
    </message>
    <message>
        <source>Paint on top of all again</source>
        <translation>Wieder über allem malen</translation>
    </message>
    <message>
        <source>&amp;Hide Others</source>
        <translation>&amp;Andere ausblenden</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Show only this layer, or all again</source>
        <translation>Nur diese Ebene zeigen oder wieder alle</translation>
    </message>
    <message>
        <source>Show other layers</source>
        <translation>Andere Ebenen zeigen</translation>
    </message>
    <message>
        <source>Hide other layers</source>
        <translation>Andere Ebenen ausblenden</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>Nichts ändert sich.</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is a mask, and the picture would change.</source>
        <translation>Nicht vereint: Eine der beiden Ebenen ist eine Maske, und das Bild würde sich ändern.</translation>
    </message>
    <message>
        <source>Not merged: the layer below is clipped, and the picture would change.</source>
        <translation>Nicht vereint: Die Ebene darunter ist auf Unteres begrenzt, und das Bild würde sich ändern.</translation>
    </message>
    <message>
        <source>Not merged: what lies above is clipped to this layer, and the picture would change.</source>
        <translation>Nicht vereint: Was darüber liegt, ist auf diese Ebene begrenzt, und das Bild würde sich ändern.</translation>
    </message>
    <message>
        <source>So that the picture stays, %1 is a group of its own within %2.</source>
        <translation>Damit das Bild bleibt, ist %1 eine eigene Gruppe in %2.</translation>
    </message>
    <message>
        <source>Put the layer onto the one just below it; the picture stays</source>
        <translation>Vereint die Ebene mit der direkt darunter; das Bild bleibt</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>&amp;Ebene</translation>
    </message>
    <message>
        <source>&amp;This Layer Only</source>
        <translation>Nur diese &amp;Ebene</translation>
    </message>
    <message>
        <source>Tools reach only what is on the layer, where there is one</source>
        <translation>Werkzeuge erreichen nur, was auf der Ebene liegt, falls es eine gibt</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>The selected groups are seen here, and left out of what is exported</source>
        <translation>Die ausgewählten Gruppen sind hier zu sehen, aber nicht in dem, was exportiert wird</translation>
    </message>
    <message>
        <source>Underlay to Layer</source>
        <translation>Vorlage zur Ebene machen</translation>
    </message>
    <message>
        <source>Make an image layer below all of the underlay, where it lies; it is exported then</source>
        <translation>Aus der Vorlage, wo sie liegt, eine Bildebene unter allem machen; sie wird dann mit exportiert</translation>
    </message>
    <message>
        <source>Picture to Stro&amp;kes…</source>
        <translation>Bild in Striche um&amp;wandeln …</translation>
    </message>
    <message>
        <source>Strokes that look like a picture, of a file or the underlay, as a layer</source>
        <translation>Striche, die wie ein Bild aussehen, das einer Datei oder der Vorlage, als Ebene</translation>
    </message>
    <message>
        <source>Import &amp;Picture as Layer…</source>
        <translation>Bild als Ebene i&amp;mportieren …</translation>
    </message>
    <message>
        <source>A picture as a layer among the others: with opacity and mode, and in what is exported</source>
        <translation>Ein Bild als Ebene unter den anderen: mit Deckkraft und Modus, und in dem, was exportiert wird</translation>
    </message>
    <message>
        <source>Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one</source>
        <translation>Striche, SVG-Pfade oder ein Bild am Zeiger einfügen; eine Farbe wird zur aktuellen</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>Zeichnun&amp;g exportieren …</translation>
    </message>
    <message>
        <source>Prin&amp;t…</source>
        <translation>D&amp;rucken …</translation>
    </message>
    <message>
        <source>On paper, or as a page of a PDF file</source>
        <translation>Auf Papier oder als Seite einer PDF-Datei</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>Druck&amp;vorschau …</translation>
    </message>
    <message>
        <source>See the page in large before it is printed</source>
        <translation>Die Seite groß ansehen, bevor sie gedruckt wird</translation>
    </message>
    <message>
        <source>Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)</source>
        <translation>Genaue Umrisse und Bänder der Farbe für Inkscape, Plotter und Browser (SVG)</translation>
    </message>
    <message>
        <source>Soft Proof</source>
        <translation>Farbprüfung</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>Shows the colours that are left on another device, as a press, by its profile</source>
        <translation>Zeigt nach dem Profil eines anderen Geräts, etwa einer Druckmaschine, welche Farben dort bleiben</translation>
    </message>
    <message>
        <source>Gamut &amp;Warning</source>
        <translation>Farbu&amp;mfangwarnung</translation>
    </message>
    <message>
        <source>Marks the colours that the device of the soft proof does not have</source>
        <translation>Markiert Farben, die das geprüfte Gerät nicht hat</translation>
    </message>
    <message>
        <source>Soft Proof with Profile…</source>
        <translation>Farbprüfung mit Profil …</translation>
    </message>
    <message>
        <source>Chooses the profile of the device whose colours are shown</source>
        <translation>Wählt das Profil des Geräts, dessen Farben gezeigt werden</translation>
    </message>
    <message>
        <source>It is clipped to a layer that is hidden now, so nothing of it is seen.</source>
        <translation>Sie ist auf eine Ebene begrenzt, die jetzt verborgen ist; darum ist nichts von ihr zu sehen.</translation>
    </message>
    <message>
        <source>&amp;Fewer Strokes…</source>
        <translation>&amp;Weniger Striche…</translation>
    </message>
    <message>
        <source>Make fewer strokes that look like the selected ones</source>
        <translation>Weniger Striche machen, die wie die ausgewählten aussehen</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>What Suffuse does and how; the key opens the page about what you are working with</source>
        <translation>Was Suffuse kann und wie; die Taste öffnet die Seite zu dem, womit Sie gerade arbeiten</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>&amp;Welcome…</source>
        <translation>&amp;Willkommen …</translation>
    </message>
    <message>
        <source>New paintings, recent ones, samples, and short lessons</source>
        <translation>Neue Bilder, letzte, Beispiele und kurze Lektionen</translation>
    </message>
    <message>
        <source>Nothing is selected: click paint with Select first.</source>
        <translation>Nichts ist ausgewählt: Klicken Sie zuerst mit Auswählen auf Farbe.</translation>
    </message>
    <message>
        <source>Nothing is painted yet.</source>
        <translation>Noch ist nichts gemalt.</translation>
    </message>
    <message>
        <source>Nothing is locked.</source>
        <translation>Nichts ist gesperrt.</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>Nichts ist ausgeblendet.</translation>
    </message>
    <message>
        <source>Select two strokes or more; to the canvas one can be aligned, too.</source>
        <translation>Wählen Sie zwei Striche oder mehr aus; an der Leinwand lässt sich auch einer ausrichten.</translation>
    </message>
    <message>
        <source>No layer is chosen: click one in the Strokes dock, or begin one with New Layer.</source>
        <translation>Keine Ebene ist gewählt: Klicken Sie in der Leiste Striche auf eine, oder beginnen Sie eine mit Neue Ebene.</translation>
    </message>
    <message>
        <source>The painting has no layers yet: New Layer begins one.</source>
        <translation>Das Bild hat noch keine Ebenen: Neue Ebene beginnt eine.</translation>
    </message>
    <message>
        <source>Select a group that this can be.</source>
        <translation>Wählen Sie eine Gruppe aus, die das sein kann.</translation>
    </message>
    <message>
        <source>Select strokes of a group.</source>
        <translation>Wählen Sie Striche einer Gruppe aus.</translation>
    </message>
    <message>
        <source>Select a text.</source>
        <translation>Wählen Sie einen Text aus.</translation>
    </message>
    <message>
        <source>Select strokes without a fill.</source>
        <translation>Wählen Sie Striche ohne Füllung aus.</translation>
    </message>
    <message>
        <source>Select a fill of one colour.</source>
        <translation>Wählen Sie eine einfarbige Füllung aus.</translation>
    </message>
    <message>
        <source>Select a fill with a gradient.</source>
        <translation>Wählen Sie eine Füllung mit einem Verlauf aus.</translation>
    </message>
    <message>
        <source>Select two strokes or more.</source>
        <translation>Wählen Sie zwei Striche oder mehr aus.</translation>
    </message>
    <message>
        <source>Select a stroke that was combined or cut into parts.</source>
        <translation>Wählen Sie einen Strich aus, der verbunden oder zerteilt wurde.</translation>
    </message>
    <message>
        <source>Select a stroke from which something was erased softly.</source>
        <translation>Wählen Sie einen Strich aus, von dem etwas weich radiert wurde.</translation>
    </message>
    <message>
        <source>The painting has no underlay.</source>
        <translation>Das Bild hat keine Vorlage.</translation>
    </message>
    <message>
        <source>Select paint that was wetted again.</source>
        <translation>Wählen Sie Farbe aus, die wieder befeuchtet wurde.</translation>
    </message>
    <message>
        <source>Copy an appearance first.</source>
        <translation>Kopieren Sie zuerst ein Aussehen.</translation>
    </message>
    <message>
        <source>The painting has no swatches.</source>
        <translation>Das Bild hat keine Farbfelder.</translation>
    </message>
    <message>
        <source>The painting has no file yet: save it first.</source>
        <translation>Das Bild hat noch keine Datei: Speichern Sie es zuerst.</translation>
    </message>
    <message>
        <source>The clipboard has nothing that can be painted.</source>
        <translation>Die Zwischenablage enthält nichts, was sich malen lässt.</translation>
    </message>
    <message>
        <source>An export is still under way.</source>
        <translation>Ein Export läuft noch.</translation>
    </message>
    <message>
        <source>Search in the Strokes dock first.</source>
        <translation>Suchen Sie zuerst in der Leiste Striche.</translation>
    </message>
    <message>
        <source>Switch the soft proof on first.</source>
        <translation>Schalten Sie zuerst die Farbprüfung ein.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Select nodes with Segments first.</source>
        <translation>Wählen Sie zuerst mit Segmente Knoten aus.</translation>
    </message>
    <message>
        <source>Select segments, or the nodes at their ends, with Segments first.</source>
        <translation>Wählen Sie zuerst mit Segmente Segmente oder die Knoten an ihren Enden aus.</translation>
    </message>
    <message>
        <source>Select two end nodes with Segments first.</source>
        <translation>Wählen Sie zuerst mit Segmente zwei Endknoten aus.</translation>
    </message>
    <message>
        <source>&amp;Show the Axes of the Symmetry</source>
        <translation>Achsen der Symmetrie &amp;zeigen</translation>
    </message>
    <message>
        <source>Also the square that moves them and the disc that turns them</source>
        <translation>Auch das Quadrat, das sie verschiebt, und die Scheibe, die sie dreht</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Hilfslinie</translation>
    </message>
    <message>
        <source>Horizontal place</source>
        <translation>Waagrechte Lage</translation>
    </message>
    <message>
        <source>Vertical place</source>
        <translation>Senkrechte Lage</translation>
    </message>
    <message>
        <source>Show the &amp;Rulers</source>
        <translation>L&amp;ineale zeigen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Along the upper and the left edge; guides are dragged out of them, and back into them</source>
        <translation>Am oberen und am linken Rand; Hilfslinien werden aus ihnen heraus- und in sie zurückgezogen</translation>
    </message>
    <message>
        <source>Show the &amp;Guides</source>
        <translation>&amp;Hilfslinien zeigen</translation>
    </message>
    <message>
        <source>&amp;Snap to Guides</source>
        <translation>An Hilfslinien &amp;einrasten</translation>
    </message>
    <message>
        <source>Nodes, shapes and what is moved; paint goes where the hand goes</source>
        <translation>Knoten, Formen und was bewegt wird; Farbe folgt der Hand</translation>
    </message>
    <message>
        <source>&amp;Lock the Guides</source>
        <translation>Hilfslinien &amp;sperren</translation>
    </message>
    <message>
        <source>They cannot be dragged, and new ones still can be made</source>
        <translation>Sie lassen sich nicht ziehen; neue können weiter entstehen</translation>
    </message>
    <message>
        <source>Add a Le&amp;vel Guide…</source>
        <translation>&amp;Waagrechte Hilfslinie hinzufügen …</translation>
    </message>
    <message>
        <source>Add an &amp;Upright Guide…</source>
        <translation>Senk&amp;rechte Hilfslinie hinzufügen …</translation>
    </message>
    <message>
        <source>Remove &amp;All Guides</source>
        <translation>&amp;Alle Hilfslinien entfernen</translation>
    </message>
    <message>
        <source>S&amp;how the Assistants</source>
        <translation>Zeichen&amp;hilfen zeigen</translation>
    </message>
    <message>
        <source>Nothing is led by those that are not seen</source>
        <translation>Was nicht zu sehen ist, führt auch keine Striche</translation>
    </message>
    <message>
        <source>&amp;Snap to Assistants</source>
        <translation>An Zeichenhilfen &amp;einrasten</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>A stroke of the Brush follows the assistant whose direction it begins with</source>
        <translation>Ein Pinselstrich folgt der Zeichenhilfe, in deren Richtung er beginnt</translation>
    </message>
    <message>
        <source>Remove &amp;All Assistants</source>
        <translation>&amp;Alle Zeichenhilfen entfernen</translation>
    </message>
    <message>
        <source>There are no assistants.</source>
        <translation>Es gibt keine Zeichenhilfen.</translation>
    </message>
    <message>
        <source>Assistants</source>
        <translation>Zeichenhilfen</translation>
    </message>
    <message>
        <source>Lines, vanishing points and ellipses that lead strokes</source>
        <translation>Linien, Fluchtpunkte und Ellipsen, die Striche führen</translation>
    </message>
    <message>
        <source>Mirrored &amp;Left and Right</source>
        <translation>&amp;Links und rechts gespiegelt</translation>
    </message>
    <message>
        <source>What is painted on one side of an upright axis comes on the other, too</source>
        <translation>Was auf einer Seite einer aufrechten Achse gemalt wird, kommt auch auf die andere</translation>
    </message>
    <message>
        <source>Mirrored &amp;Top and Bottom</source>
        <translation>&amp;Oben und unten gespiegelt</translation>
    </message>
    <message>
        <source>What is painted above a level axis comes below it, too</source>
        <translation>Was über einer waagrechten Achse gemalt wird, kommt auch darunter</translation>
    </message>
    <message>
        <source>Mirrored &amp;Both Ways</source>
        <translation>&amp;Beidseitig gespiegelt</translation>
    </message>
    <message>
        <source>What is painted comes in all four corners of a cross</source>
        <translation>Was gemalt wird, kommt in alle vier Winkel eines Kreuzes</translation>
    </message>
    <message>
        <source>&amp;Rotated around the Centre</source>
        <translation>Um die Mitte ge&amp;dreht</translation>
    </message>
    <message>
        <source>What is painted comes once in each arm around the centre</source>
        <translation>Was gemalt wird, kommt einmal in jeden Arm um die Mitte</translation>
    </message>
    <message>
        <source>&amp;Kaleidoscope</source>
        <translation>&amp;Kaleidoskop</translation>
    </message>
    <message>
        <source>What is painted comes in each arm around the centre, and mirrored beside it</source>
        <translation>Was gemalt wird, kommt in jeden Arm um die Mitte und gespiegelt daneben</translation>
    </message>
    <message>
        <source>&amp;Paint in Symmetry</source>
        <translation>S&amp;ymmetrisch malen</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step</source>
        <translation>Striche, Formen und Umrisse kommen mehrfach, gespiegelt oder gedreht, als ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
        <source>Number of &amp;Arms…</source>
        <translation>Zahl der &amp;Arme …</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Arms around the centre</source>
        <translation>Arme um die Mitte</translation>
    </message>
    <message>
        <source>An&amp;gle of the Axes…</source>
        <translation>&amp;Winkel der Achsen …</translation>
    </message>
    <message>
        <source>Degrees clockwise</source>
        <translation>Grad im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Axes to the &amp;Middle of the Canvas</source>
        <translation>Achsen in die &amp;Mitte der Leinwand</translation>
    </message>
    <message>
        <source>The centre of the symmetry lies in the middle again, and the axes are upright and level</source>
        <translation>Die Mitte der Symmetrie liegt wieder in der Mitte, und die Achsen stehen aufrecht und waagrecht</translation>
    </message>
    <message>
        <source>Rulers and Guides</source>
        <translation>Lineale und Hilfslinien</translation>
    </message>
    <message>
        <source>Workspace to &amp;Paint</source>
        <translation>Arbeitsbereich zum &amp;Malen</translation>
    </message>
    <message>
        <source>Colour, brushes and strokes beside a wide canvas</source>
        <translation>Farbe, Pinsel und Striche neben einer breiten Leinwand</translation>
    </message>
    <message>
        <source>Workspace to &amp;Refine</source>
        <translation>Arbeitsbereich zum &amp;Verfeinern</translation>
    </message>
    <message>
        <source>Inspector, strokes, history and colour</source>
        <translation>Inspektor, Striche, Verlauf und Farbe</translation>
    </message>
    <message>
        <source>Workspace for &amp;Time</source>
        <translation>Arbeitsbereich für die &amp;Zeit</translation>
    </message>
    <message>
        <source>A high timeline, with inspector and strokes</source>
        <translation>Eine hohe Zeitleiste mit Inspektor und Strichen</translation>
    </message>
    <message>
        <source>&amp;Save Workspace…</source>
        <translation>Arbeitsbereich &amp;speichern …</translation>
    </message>
    <message>
        <source>Keep where docks and tool bars stand now, under a name</source>
        <translation>Behalten, wo Andockfenster und Werkzeugleisten jetzt stehen, unter einem Namen</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>Arbeitsbereiche</translation>
    </message>
    <message>
        <source>Rulers in &amp;Canvas Units</source>
        <translation>Lineale in &amp;Leinwand-Einheiten</translation>
    </message>
    <message>
        <source>Rulers in &amp;Millimetres</source>
        <translation>Lineale in &amp;Millimetern</translation>
    </message>
    <message>
        <source>Rulers in &amp;Inches</source>
        <translation>Lineale in &amp;Zoll</translation>
    </message>
    <message>
        <source>New View</source>
        <translation>Neue Ansicht</translation>
    </message>
    <message>
        <source>A window that shows the painting from elsewhere while you paint; each edit shows in both</source>
        <translation>Ein Fenster, das das Gemälde von anderswo zeigt, während Sie malen; jede Änderung zeigt sich in beiden</translation>
    </message>
    <message>
        <source>&amp;Repeat Last Extension</source>
        <translation>Letzte Erweiterung &amp;wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+X</source>
        <translation>Ctrl+Alt+X</translation>
    </message>
    <message>
        <source>Once more, with the same values</source>
        <translation>Noch einmal, mit denselben Werten</translation>
    </message>
    <message>
        <source>&amp;Manage Extensions…</source>
        <translation>Erweiterungen &amp;verwalten …</translation>
    </message>
    <message>
        <source>Which extensions there are, which are in the menu, and what went wrong</source>
        <translation>Welche Erweiterungen es gibt, welche im Menü stehen und was schiefging</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected.</source>
        <translation>Nichts Sichtbares und Entsperrtes ist ausgewählt.</translation>
    </message>
    <message>
        <source>E&amp;xtensions</source>
        <translation>E&amp;rweiterungen</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>Paint with Ke&amp;ys</source>
        <translation>Mit Tast&amp;en malen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it</source>
        <translation>Pfeiltasten bewegen ein Fadenkreuz über die Leinwand, die Leertaste setzt das Werkzeug auf und hebt es ab</translation>
    </message>
    <message>
        <source>There are no guides.</source>
        <translation>Es gibt keine Hilfslinien.</translation>
    </message>
    <message>
        <source>Choose a symmetry that turns, or the kaleidoscope, first.</source>
        <translation>Wählen Sie zuerst eine drehende Symmetrie oder das Kaleidoskop.</translation>
    </message>
    <message>
        <source>No extension has run yet.</source>
        <translation>Noch lief keine Erweiterung.</translation>
    </message>
</context>
<context>
    <name>suffuse::CompareButton</name>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Shows the picture as it was before the last changes to the selection: while held, or click to switch back and forth.</source>
        <translation>Zeigt das Bild, wie es vor den letzten Änderungen an der Auswahl war: solange gedrückt, oder ein Klick wechselt hin und her.</translation>
    </message>
</context>
<context>
    <name>suffuse::CrossSectionPlot</name>
    <message>
        <source>Not painted yet</source>
        <translation>Noch nicht gemalt</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Covers up to %1</source>
        <translation>Deckt bis %1</translation>
    </message>
</context>
<context>
    <name>suffuse::CurrentLayer</name>
    <message>
        <source>Layer: %1</source>
        <translation>Ebene: %1</translation>
    </message>
    <message>
        <source>No layer: paint goes on top of all</source>
        <translation>Keine Ebene: Farbe kommt über alles</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>New layer: %1. Paint on it.</source>
        <translation>Neue Ebene: %1. Malen Sie darauf.</translation>
    </message>
    <message>
        <source>New clipped layer: %1. Paint on it, where the layer below has paint.</source>
        <translation>Neue begrenzte Ebene: %1. Malen Sie darauf, wo die Ebene darunter Farbe hat.</translation>
    </message>
    <message>
        <source>All is shown again, since this would be hidden</source>
        <translation>Alles ist wieder sichtbar, da dies sonst verborgen wäre</translation>
    </message>
    <message>
        <source>%1 is locked: nothing is painted there</source>
        <translation>%1 ist gesperrt: Dort wird nichts gemalt</translation>
    </message>
    <message>
        <source>%1 is hidden: nothing is painted there</source>
        <translation>%1 ist ausgeblendet: Dort wird nichts gemalt</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 (Kopie %2)</translation>
    </message>
    <message>
        <source>Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.</source>
        <translation>Nur was auf %1 liegt, wird erreicht. Ebene ▸ Nur diese Ebene erreicht wieder alles.</translation>
    </message>
</context>
<context>
    <name>suffuse::CurveEditor</name>
    <message>
        <source>along the stroke →</source>
        <translation>entlang des Strichs →</translation>
    </message>
</context>
<context>
    <name>suffuse::DensityPlot</name>
    <message>
        <source>Coverage at the peak density %1: %2 %</source>
        <translation>Deckung bei der Spitzendichte %1: %2 %</translation>
    </message>
    <message>
        <source>density φ — first of several styles</source>
        <translation>Dichte φ – erster von mehreren Stilen</translation>
    </message>
    <message>
        <source>density φ</source>
        <translation>Dichte φ</translation>
    </message>
    <message>
        <source>F(φ), peak %1</source>
        <translation>F(φ), Spitze %1</translation>
    </message>
</context>
<context>
    <name>suffuse::Docks</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>&amp;Anordnen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Vorlage</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingTool</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>What was drawn encloses no area: nothing was added.</source>
        <translation>Was gezeichnet wurde, umschließt keine Fläche: Es kam nichts hinzu.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Outline and fill</source>
        <translation>Umriss und Füllung</translation>
    </message>
    <message>
        <source>What of the shape is painted</source>
        <translation>Was von der Form gemalt wird</translation>
    </message>
</context>
<context>
    <name>suffuse::Editor</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <extracomment>name of a document that was brought back after a crash</extracomment>
        <translation>%1 (wiederhergestellt)</translation>
    </message>
    <message>
        <source>is damaged, so the painting stays as it is; save it, or open the file to see what is whole of it</source>
        <translation>ist beschädigt, darum bleibt das Bild, wie es ist; bitte speichern, oder die Datei öffnen, um zu sehen, was davon heil ist</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurück zur Datei</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserFields</name>
    <message>
        <source>Fade</source>
        <translation>Verblassen</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges draw in; Cut cuts curves out</source>
        <translation>Verblassen macht Farbe blasser, wo immer sie zu sehen ist; Abheben nimmt ihre Dichte weg, sodass Ränder zurückweichen; Schneiden schneidet Kurven heraus</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>How far what is taken away spreads, as a share of the radius</source>
        <translation>Wie weit das Weggenommene ausläuft, als Anteil des Radius</translation>
    </message>
    <message>
        <source>Selected Strokes</source>
        <extracomment>scope of the eraser, while no stroke is selected</extracomment>
        <translation>Ausgewählte Striche</translation>
    </message>
    <message>
        <source>Current Group</source>
        <translation>Aktuelle Gruppe</translation>
    </message>
    <message>
        <source>All Strokes</source>
        <translation>Alle Striche</translation>
    </message>
    <message>
        <source>From which strokes; without a selection, the first choice means all</source>
        <translation>Von welchen Strichen; ohne Auswahl meint das Erste alle</translation>
    </message>
    <message>
        <source>All (None Selected)</source>
        <translation>Alle (nichts ausgewählt)</translation>
    </message>
    <message>
        <source>Fade: the share of the paint that is taken. Lift: how much density, so that feathered paint gets paler and paint with a sharp edge narrower. A pen&apos;s pressure takes from it</source>
        <translation>Verblassen: der Anteil der Farbe, der weggenommen wird. Abheben: wie viel Dichte, sodass auslaufende Farbe blasser wird und scharf begrenzte schmaler. Der Druck eines Stifts mindert es</translation>
    </message>
    <message>
        <source>Sharp edges draw in.</source>
        <translation>Scharfe Ränder weichen zurück.</translation>
    </message>
</context>
<context>
    <name>suffuse::ErasureRows</name>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Fade makes paint paler; Lift takes its density away, so that edges draw in.</source>
        <translation>Verblassen macht Farbe blasser; Abheben nimmt ihre Dichte weg, sodass Ränder zurückweichen.</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Verblassen</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The diameter of the eraser, if its softness was the usual one.</source>
        <translation>Der Durchmesser des Radierers, wenn seine Weichheit die übliche war.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>The share of the paint that it takes in its middle.</source>
        <translation>Der Anteil der Farbe, den sie in ihrer Mitte wegnimmt.</translation>
    </message>
    <message>
        <source>Density taken</source>
        <translation>Genommene Dichte</translation>
    </message>
    <message>
        <source>Change size</source>
        <translation>Größe ändern</translation>
    </message>
    <message>
        <source>The density that it takes away in its middle: paint that is thinner is gone there.</source>
        <translation>Die Dichte, die sie in ihrer Mitte wegnimmt: Dünnere Farbe ist dort fort.</translation>
    </message>
    <message>
        <source>Change strength</source>
        <translation>Stärke ändern</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für die ganze Auswahl möglich: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>Change kind of erasure</source>
        <translation>Art der Radierung ändern</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserTool</name>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Verblassen: Ziehen macht die ausgewählten Striche blasser, je nach Stärke. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Verblassen: Ziehen macht die Striche der Gruppe blasser, je nach Stärke. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Verblassen: Ziehen macht Farbe blasser, je nach Stärke, wo immer sie zu sehen ist. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Abheben: Ziehen nimmt Farbe weich von den ausgewählten Strichen. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Abheben: Ziehen nimmt Farbe weich von den Strichen der Gruppe. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>Abheben: Ziehen nimmt Farbe weich weg, wo immer sie zu sehen ist. Umschalt: schneiden. [ und ]: Größe, { und }: Stärke.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Schneiden: Ziehen schneidet heraus, was von den ausgewählten Kurven unter dem Kreis liegt. Umschalt: weich radieren. [ und ]: Größe.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the group&apos;s curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Schneiden: Ziehen schneidet heraus, was von den Kurven der Gruppe unter dem Kreis liegt. Umschalt: weich radieren. [ und ]: Größe.</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>Schneiden: Ziehen schneidet heraus, was von den Kurven unter dem Kreis liegt. Umschalt: weich radieren. [ und ]: Größe.</translation>
    </message>
    <message>
        <source>Nothing is erased: no paint is seen under the circle.</source>
        <translation>Nichts wurde radiert: Unter dem Kreis ist keine Farbe zu sehen.</translation>
    </message>
    <message>
        <source>Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.</source>
        <translation>Nichts wurde geschnitten: Unter dem Kreis liegt keine Kurve. „Verblassen“ nimmt Farbe weg, wo immer sie zu sehen ist.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not selected.</source>
        <translation>Nichts wurde radiert: Was unter dem Kreis liegt, ist nicht ausgewählt.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is in another group.</source>
        <translation>Nichts wurde radiert: Was unter dem Kreis liegt, gehört zu einer anderen Gruppe.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is locked.</source>
        <translation>Nichts wurde radiert: Was unter dem Kreis liegt, ist gesperrt.</translation>
    </message>
    <message>
        <source>It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes its paint away.</source>
        <translation>Es wurde geschnitten, doch ist kaum eine Lücke zu sehen: Ihre Ränder sind weicher, als der Schnitt breit ist. „Verblassen“ nimmt ihre Farbe weg.</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not on the layer, and only that is reached.</source>
        <translation>Nichts wird radiert: Was unter dem Kreis liegt, ist nicht auf der Ebene, und nur diese wird erreicht.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportDialog</name>
    <message>
        <source>8 bit</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>16 bit floating point</source>
        <translation>16 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers.</source>
        <translation>Die Endung bestimmt das Format: png, tiff, exr, jpg, webp oder pfm, oder ora oder psd mit Ebenen.</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Ordner und Namen wählen</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Farbtiefe</translation>
    </message>
    <message>
        <source>Precision of each colour channel</source>
        <translation>Genauigkeit jedes Farbkanals</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Of JPEG and WebP; 100 is the best. WebP loses nothing then.</source>
        <translation>Für JPEG und WebP; 100 ist am besten. WebP verliert dann nichts.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Transparenter Hintergrund</translation>
    </message>
    <message>
        <source>Leaves the background out and stores how much the paint covers.</source>
        <translation>Lässt den Hintergrund weg und speichert, wie stark die Farbe deckt.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>Width in pixels; the height follows.</source>
        <translation>Breite in Pixeln; die Höhe folgt.</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>Height in pixels; the width follows.</source>
        <translation>Höhe in Pixeln; die Breite folgt.</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>Gemälde</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>“%1” has no ending of a picture format. Choose one of: %2.</source>
        <translation>„%1“ hat keine Endung eines Bildformats. Möglich sind: %2.</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen …</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Was sie jetzt enthält, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>At most %1 × %2 px</source>
        <translation>Höchstens %1 × %2 px</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>No picture format</source>
        <translation>Kein Bildformat</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What is written. The ending of the file&apos;s name says the same.</source>
        <translation>Was geschrieben wird. Die Endung des Dateinamens sagt dasselbe.</translation>
    </message>
    <message>
        <source>Pictures are written here. File ▸ Export Drawing writes SVG.</source>
        <translation>Hier entstehen Bilder. SVG schreibt Datei ▸ Zeichnung exportieren.</translation>
    </message>
    <message>
        <source>Photoshop (layers)</source>
        <translation>Photoshop (Ebenen)</translation>
    </message>
    <message>
        <source>OpenRaster (layers)</source>
        <translation>OpenRaster (Ebenen)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>The colour profile that the file has. The painting keeps the one that was chosen from a file.</source>
        <translation>Das Farbprofil der Datei. Das Bild behält das, das aus einer Datei gewählt wurde.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportJob</name>
    <message>
        <source>A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.</source>
        <translation>Ein Bild von %1 × %2 Pixeln passt nicht in den Speicher. Bitte eine kleinere Größe wählen.</translation>
    </message>
</context>
<context>
    <name>suffuse::Exporting</name>
    <message>
        <source>Exported to %1</source>
        <translation>Nach %1 exportiert</translation>
    </message>
    <message>
        <source>Printed to %1</source>
        <translation>Gedruckt in %1</translation>
    </message>
    <message>
        <source>Given to the printer %1</source>
        <translation>An den Drucker %1 übergeben</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 wird exportiert …</translation>
    </message>
</context>
<context>
    <name>suffuse::EyedropperTool</name>
    <message>
        <source>Click to take the picture&apos;s colour as the current one. Shift: the stroke&apos;s own colour.</source>
        <translation>Klick übernimmt die Farbe des Bildes als aktuelle. Umschalt: die eigene Farbe des Strichs.</translation>
    </message>
    <message>
        <source>A click takes</source>
        <translation>Ein Klick nimmt</translation>
    </message>
    <message>
        <source>The colour, to paint with</source>
        <translation>Die Farbe, zum Malen</translation>
    </message>
    <message>
        <source>The appearance, for the selection</source>
        <translation>Das Aussehen, für die Auswahl</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Angleichen</translation>
    </message>
    <message>
        <source>Select strokes first: they get the appearance of the stroke you click.</source>
        <translation>Zuerst Striche auswählen: sie erhalten das Aussehen des Strichs, der angeklickt wird.</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its appearance, and what varies along them stays. Shift: the same values all along.</source>
        <translation>Klick auf einen Strich: die gewählten erhalten sein Aussehen, und was entlang ihrer wechselt, bleibt. Umschalt: dieselben Werte von Anfang bis Ende.</translation>
    </message>
    <message>
        <source>Click to give what is selected the picture&apos;s colour. Shift: the stroke&apos;s own colour. Ctrl: its whole appearance.</source>
        <translation>Klicken gibt dem Ausgewählten die Farbe des Bildes. Umschalt: die eigene Farbe des Strichs. Strg: sein ganzes Aussehen.</translation>
    </message>
    <message>
        <source>Click to give the swatch the picture&apos;s colour. Shift: the stroke&apos;s own colour.</source>
        <translation>Klicken gibt dem Farbfeld die Farbe des Bildes. Umschalt: die eigene Farbe des Strichs.</translation>
    </message>
    <message>
        <source>A colour, or style, values and colour of a stroke for the selected ones. The colour is for what the Colour dock shows: the brush, the selection or a swatch.</source>
        <translation>Eine Farbe, oder Stil, Werte und Farbe eines Strichs für die gewählten. Die Farbe bekommt, wessen Farbe das Farbenfenster zeigt: der Pinsel, die Auswahl oder ein Farbfeld.</translation>
    </message>
    <message>
        <source>The colour, for the selection</source>
        <translation>Die Farbe, für die Auswahl</translation>
    </message>
    <message>
        <source>The colour, for the swatch</source>
        <translation>Die Farbe, für das Farbfeld</translation>
    </message>
</context>
<context>
    <name>suffuse::FiguresSection</name>
    <message>
        <source>The outline lays no paint: its density φ is 0. What is seen is the fill.</source>
        <translation>Der Umriss trägt keine Farbe: Seine Dichte φ ist 0. Zu sehen ist die Füllung.</translation>
    </message>
    <message>
        <source>Density function</source>
        <translation>Dichtefunktion</translation>
    </message>
    <message>
        <source>How density becomes coverage. The mark is the peak density of the selected segments.</source>
        <translation>Wie aus Dichte Deckung wird. Die Marke ist die Spitzendichte der ausgewählten Segmente.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>The cut through the stroke at the first selected segment, at the moment shown: coverage, on the colour that it has on the background.</source>
        <translation>Der Schnitt durch den Strich beim ersten ausgewählten Segment, zum gezeigten Zeitpunkt: die Deckung, in der Farbe, die er auf dem Hintergrund hat.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Spread s</source>
        <translation>Ausbreitung s</translation>
    </message>
    <message>
        <source>Peak density</source>
        <translation>Spitzendichte</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Halbe Breite</translation>
    </message>
    <message>
        <source>Fades away</source>
        <translation>Verblasst</translation>
    </message>
    <message>
        <source>Density in the middle of a long straight stroke, dry.</source>
        <translation>Dichte in der Mitte eines langen geraden Strichs, getrocknet.</translation>
    </message>
    <message>
        <source>From the middle to the visible edge of a long straight stroke, dry.</source>
        <translation>Von der Mitte bis zum sichtbaren Rand eines langen geraden Strichs, getrocknet.</translation>
    </message>
    <message>
        <source>When the paint has spread so thin that nothing of it is visible any more.</source>
        <translation>Wann die Farbe so dünn verlaufen ist, dass nichts mehr zu sehen ist.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>partly, from %1</source>
        <translation>teilweise, ab %1</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>Spread along</source>
        <translation>Ausbreitung längs</translation>
    </message>
    <message>
        <source>How far the paint has spread across the curve once it is dry: √(4·D·t_max).</source>
        <translation>Wie weit die Farbe getrocknet quer zur Kurve verlaufen ist: √(4·D·t_max).</translation>
    </message>
    <message>
        <source>How far it has spread along the curve.</source>
        <translation>Wie weit sie entlang der Kurve verlaufen ist.</translation>
    </message>
    <message>
        <source>Spread across</source>
        <translation>Ausbreitung quer</translation>
    </message>
    <message>
        <source>Takes away</source>
        <translation>Nimmt weg</translation>
    </message>
    <message>
        <source>How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max).</source>
        <translation>Wie weich die Radierung endet: wie weit sie sich neben ihrer Kurve ausgebreitet hat, √(4·D·t_max).</translation>
    </message>
    <message>
        <source>What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if it lifts, and paint that is thinner is gone there.</source>
        <translation>Was ein Segment der Radierung in seiner Mitte wegnimmt: den Anteil der Farbe, wenn es verblassen lässt; Dichte, wenn es abhebt, und dünnere Farbe ist dort ganz weg.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileOpening</name>
    <message>
        <source>Pictures with layers (*.ora *.psd)</source>
        <translation>Bilder mit Ebenen (*.ora *.psd)</translation>
    </message>
    <message>
        <source>All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</source>
        <translation>Alles, was sich öffnen lässt (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</translation>
    </message>
    <message>
        <source>Suffuse paintings (*.suffuse *.json)</source>
        <translation>Suffuse-Bilder (*.suffuse *.json)</translation>
    </message>
    <message>
        <source>Backups of paintings (*.suffuse~* *.json~*)</source>
        <translation>Sicherungskopien von Bildern (*.suffuse~* *.json~*)</translation>
    </message>
    <message>
        <source>Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</source>
        <translation>Stiftaufzeichnungen (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</translation>
    </message>
    <message>
        <source>Drawings (*.svg *.svgz *.pdf)</source>
        <translation>Zeichnungen (*.svg *.svgz *.pdf)</translation>
    </message>
    <message>
        <source>Diffusion curves (*.xml)</source>
        <translation>Diffusionskurven (*.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>“%1” is open already.</source>
        <translation>„%1“ ist schon geöffnet.</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was opened; the file itself is left as it is.</source>
        <translation>„%1“ ist beschädigt. Was davon heil ist, wurde geöffnet; die Datei selbst bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&amp;Clear the List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
</context>
<context>
    <name>suffuse::FileRestoring</name>
    <message>
        <source>Revert “%1” to what the file holds?</source>
        <translation>„%1“ auf das zurücksetzen, was in der Datei steht?</translation>
    </message>
    <message>
        <source>What was painted since the last save goes; Undo brings it back.</source>
        <translation>Was seit dem letzten Speichern gemalt wurde, geht weg; Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore backup of %1</source>
        <translation>Sicherungskopie vom %1 wiederherstellen</translation>
    </message>
    <message>
        <source>The backup of %1 is back. Undo takes it away again; no file changes until you save.</source>
        <translation>Die Sicherungskopie vom %1 ist zurück. Rückgängig nimmt sie wieder weg; keine Datei ändert sich, bevor gespeichert wird.</translation>
    </message>
    <message>
        <source>The backup of %1 is what you see: nothing has changed.</source>
        <translation>Die Sicherungskopie vom %1 ist das, was man sieht: Nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>The backup is damaged. What is whole of it was restored.</source>
        <translation>Die Sicherungskopie ist beschädigt. Was davon heil ist, wurde wiederhergestellt.</translation>
    </message>
</context>
<context>
    <name>suffuse::FileSaving</name>
    <message>
        <source>What you paint now would not survive a crash: %1. Painting goes on; save from time to time.</source>
        <translation>Was Sie jetzt malen, würde einen Absturz nicht überstehen: %1. Sie können weitermalen; bitte ab und zu speichern.</translation>
    </message>
    <message>
        <source>“%1” is gone from its folder. Save to put it back.</source>
        <translation>„%1“ ist aus dem Ordner verschwunden. Speichern legt es wieder dorthin.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>name of the file that a copy is saved to, beside that of the painting</extracomment>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>„%1“ wird gespeichert …</translation>
    </message>
    <message>
        <source>A copy is saved as “%1”.</source>
        <translation>Eine Kopie ist als „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>“%1” is saved already.</source>
        <translation>„%1“ ist schon gespeichert.</translation>
    </message>
    <message>
        <source>%1 (without what is still being drawn)</source>
        <translation>%1 (ohne das, was noch gezeichnet wird)</translation>
    </message>
    <message>
        <source>Saved “%1”, %2</source>
        <translation>„%1“ gespeichert, %2</translation>
    </message>
    <message>
        <source>Saved “%1”, but %2</source>
        <translation>„%1“ gespeichert, aber %2</translation>
    </message>
    <message>
        <source>“%1” is not saved.</source>
        <translation>„%1“ ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse-Bild</translation>
    </message>
    <message>
        <source>Text form</source>
        <translation>Textform</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Choose another name, or close that window first.</source>
        <translation>„%1“ ist in einem anderen Fenster geöffnet. Bitte einen anderen Namen wählen oder zuerst jenes Fenster schließen.</translation>
    </message>
    <message>
        <source>“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.</source>
        <translation>„%1“ enthält schlichte Linien und Flächen, für andere Programme. „Zeichnung exportieren“ behält weiche und dunkle Ränder.</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
</context>
<context>
    <name>suffuse::FileTypes</name>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse-Bild</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse-Pinsel</translation>
    </message>
    <message>
        <source>Backup of a painting</source>
        <translation>Sicherung eines Bildes</translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>%n Einstellungs- oder Füllebene</numerusform>
            <numerusform>%n Einstellungs- oder Füllebenen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>die Effekte von %n Ebene</numerusform>
            <numerusform>die Effekte von %n Ebenen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>die Maske von %n Gruppe</numerusform>
            <numerusform>die Masken von %n Gruppen</numerusform>
        </translation>
    </message>
    <message>
        <source>This Photoshop file is damaged.</source>
        <translation>Diese Photoshop-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>Photoshop picture</source>
        <translation>Photoshop-Bild</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.</source>
        <translation>Photoshop-Dateien mit über 30.000 Pixeln je Seite (PSB) werden nicht gelesen. Speichern Sie sie als PSD.</translation>
    </message>
    <message>
        <source>Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.</source>
        <translation>Nur Photoshop-Dateien in RGB oder Grau mit 8 oder 16 Bit werden gelesen. Wandeln Sie sie in RGB um.</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>%n Ebene, deren Bild fehlt, beschädigt oder zu groß ist</numerusform>
            <numerusform>%n Ebenen, deren Bild fehlt, beschädigt oder zu groß ist</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>der Modus von %n Ebene</numerusform>
            <numerusform>die Modi von %n Ebenen</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: %1.</source>
        <translation>Diese OpenRaster-Datei ist beschädigt: %1.</translation>
    </message>
    <message>
        <source>it has no list of its layers</source>
        <translation>Ihr fehlt das Verzeichnis ihrer Ebenen</translation>
    </message>
    <message>
        <source>its list of layers cannot be read</source>
        <translation>Das Verzeichnis ihrer Ebenen ist nicht lesbar</translation>
    </message>
    <message>
        <source>is a folder; give a file name inside it</source>
        <translation>ist ein Ordner; bitte einen Dateinamen darin angeben</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file; save to a file</source>
        <translation>ist ein Gerät oder eine Pipe, keine Datei; bitte in eine Datei speichern</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; create it or choose another one</source>
        <translation>den Ordner %1 gibt es nicht; bitte anlegen oder einen anderen wählen</translation>
    </message>
    <message>
        <source>%1 is not a folder; choose another place</source>
        <translation>%1 ist kein Ordner; bitte einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>the folder %1 is read-only; choose another one or change its permissions</source>
        <translation>der Ordner %1 ist schreibgeschützt; bitte einen anderen wählen oder die Rechte ändern</translation>
    </message>
    <message>
        <source>The file has no name; choose one</source>
        <translation>Die Datei hat keinen Namen; bitte einen wählen</translation>
    </message>
    <message>
        <source>would have more than 2 GB; nothing was written</source>
        <translation>hätte mehr als 2 GB; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>cannot be written (%1); choose another place</source>
        <translation>kann nicht geschrieben werden (%1); bitte einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>%1 (%2); the old file, if there was one, is as before. Free some space or choose another place</source>
        <translation>%1 (%2); die alte Datei, falls es sie gab, ist unverändert. Bitte Platz schaffen oder einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>could not be written in full</source>
        <translation>konnte nicht vollständig geschrieben werden</translation>
    </message>
    <message>
        <source>could not be put in place</source>
        <translation>konnte nicht an ihren Platz gebracht werden</translation>
    </message>
    <message>
        <source>was written, but the folder could not be brought to the disk (%1); save once more before you switch off</source>
        <translation>wurde geschrieben, aber der Ordner kam nicht auf die Platte (%1); bitte vor dem Ausschalten noch einmal speichern</translation>
    </message>
    <message>
        <source>the image has %1 MB; at most 64 MB are possible, make it smaller</source>
        <translation>das Bild hat %1 MB; höchstens 64 MB sind möglich, bitte verkleinern</translation>
    </message>
    <message>
        <source>is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them</source>
        <translation>ist kein PNG-, JPEG-, TIFF-, WebP- oder EXR-Bild; bitte in eines davon umwandeln</translation>
    </message>
    <message>
        <source>is empty; give a data: URL or the path of an image file</source>
        <translation>ist leer; bitte eine data:-URL oder den Pfad einer Bilddatei angeben</translation>
    </message>
    <message>
        <source>the image file %1 is missing; put it there or correct the path</source>
        <translation>die Bilddatei %1 fehlt; bitte dort ablegen oder den Pfad berichtigen</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>the image file %1 has %2 MB; at most 64 MB are possible</source>
        <translation>die Bilddatei %1 hat %2 MB; höchstens 64 MB sind möglich</translation>
    </message>
    <message>
        <source>the image file %1 cannot be read: %2</source>
        <translation>die Bilddatei %1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>is not a data:…;base64,… URL</source>
        <translation>ist keine data:…;base64,…-URL</translation>
    </message>
    <message>
        <source>the image is too large; at most 64 MB are possible</source>
        <translation>das Bild ist zu groß; höchstens 64 MB sind möglich</translation>
    </message>
    <message>
        <source>the base64 data of the image are damaged</source>
        <translation>die base64-Daten des Bildes sind beschädigt</translation>
    </message>
    <message>
        <source>has more than 2 GB; that is more than can be opened</source>
        <translation>hat mehr als 2 GB; das ist mehr, als sich öffnen lässt</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse-Bild</translation>
    </message>
    <message>
        <source>Suffuse text form</source>
        <translation>Suffuse-Textform</translation>
    </message>
    <message>
        <source>Ink recording (CSV)</source>
        <translation>Tintenaufzeichnung (CSV)</translation>
    </message>
    <message>
        <source>Universal Ink</source>
        <translation>Universal Ink</translation>
    </message>
    <message>
        <source>Excalidraw drawing</source>
        <translation>Excalidraw-Zeichnung</translation>
    </message>
    <message>
        <source>MyPaint events</source>
        <translation>MyPaint-Ereignisse</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>Unbekanntes Format</translation>
    </message>
    <message>
        <source>there is no such file: %1</source>
        <translation>diese Datei gibt es nicht: %1</translation>
    </message>
    <message>
        <source>is a folder; give a file inside it</source>
        <translation>ist ein Ordner; bitte eine Datei darin angeben</translation>
    </message>
    <message>
        <source>could not be opened: %1; check its permissions</source>
        <translation>konnte nicht geöffnet werden: %1; bitte die Rechte prüfen</translation>
    </message>
    <message>
        <source>the ending is neither .suffuse nor .json; choose one of them</source>
        <translation>die Endung ist weder .suffuse noch .json; bitte eine davon wählen</translation>
    </message>
    <message>
        <source>%1: has less than 2 numbers</source>
        <translation>%1: hat weniger als 2 Zahlen</translation>
    </message>
    <message>
        <source>holds no freedraw elements; only those become strokes</source>
        <translation>enthält keine Freihandelemente; nur diese werden zu Strichen</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>: is not a list of numbers</source>
        <translation>: ist keine Liste von Zahlen</translation>
    </message>
    <message>
        <source>%1[%2]: is not a number within ±1e15</source>
        <translation>%1[%2]: ist keine Zahl innerhalb von ±1e15</translation>
    </message>
    <message>
        <source>line %1, column %2: “%3” is not a number within ±1e15</source>
        <translation>Zeile %1, Spalte %2: „%3“ ist keine Zahl innerhalb von ±1e15</translation>
    </message>
    <message>
        <source>is empty; there is nothing to paint</source>
        <translation>ist leer; es gibt nichts zu malen</translation>
    </message>
    <message>
        <source>line %1: no columns x and y; name the columns x, y, time and pressure</source>
        <translation>Zeile %1: keine Spalten x und y; bitte die Spalten x, y, time und pressure nennen</translation>
    </message>
    <message>
        <source>%1: splineX has %2 numbers, splineY %3</source>
        <translation>%1: splineX hat %2 Zahlen, splineY %3</translation>
    </message>
    <message>
        <source>an object {…}</source>
        <translation>ein Objekt {…}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>eine Liste […]</translation>
    </message>
    <message>
        <source>the file ends here, “%1” is missing; it is probably cut off</source>
        <translation>die Datei endet hier, „%1“ fehlt; sie ist wohl abgeschnitten</translation>
    </message>
    <message>
        <source>expected “,” or “%1” before “%2”</source>
        <translation>vor „%2“ fehlt „,“ oder „%1“</translation>
    </message>
    <message>
        <source>expected a member&apos;s name in quotes before “%1”</source>
        <translation>vor „%1“ fehlt der Name eines Eintrags in Anführungszeichen</translation>
    </message>
    <message>
        <source>expected “:” after “%1”</source>
        <translation>nach „%1“ fehlt „:“</translation>
    </message>
    <message>
        <source>is given twice; keep one of them</source>
        <translation>steht zweimal da; bitte nur einmal</translation>
    </message>
    <message>
        <source>is not a member of this format; correct or remove it</source>
        <translation>gehört nicht zu diesem Format; bitte berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>a string has a wrong escape “\%1”</source>
        <translation>eine Zeichenkette hat eine falsche Maskierung „\%1“</translation>
    </message>
    <message>
        <source>the file ends inside a string; it is probably cut off</source>
        <translation>die Datei endet in einer Zeichenkette; sie ist wohl abgeschnitten</translation>
    </message>
    <message>
        <source>a string has a control character; write it as an escape such as \n</source>
        <translation>eine Zeichenkette hat ein Steuerzeichen; bitte maskieren, etwa als \n</translation>
    </message>
    <message>
        <source>the file ends here; it is probably cut off</source>
        <translation>die Datei endet hier; sie ist wohl abgeschnitten</translation>
    </message>
    <message>
        <source>expected %1 before “%2”</source>
        <translation>vor „%2“ fehlt %1</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 ist nicht %2</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>hat %1 Zahlen statt %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>%1 is too large; the largest number is %2</source>
        <translation>%1 ist zu groß; die größte Zahl ist %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^64 − 1</source>
        <translation>%1 ist keine ganze Zahl von 0 bis 2^64 − 1</translation>
    </message>
    <message>
        <source>%1 s is not in [-1e12, 1e12]</source>
        <translation>%1 s liegt nicht in [-1e12, 1e12]</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>eine Zeichenkette in Anführungszeichen</translation>
    </message>
    <message>
        <source>is not UTF-8; save the file in that encoding</source>
        <translation>ist kein UTF-8; bitte die Datei so speichern</translation>
    </message>
    <message>
        <source>“%1” follows after the end of the painting; remove it</source>
        <translation>„%1“ folgt nach dem Ende des Bildes; bitte entfernen</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>Standardeingabe</translation>
    </message>
    <message>
        <source>holds no pen strokes; there is nothing to paint</source>
        <translation>enthält keine Stiftstriche; es gibt nichts zu malen</translation>
    </message>
    <message>
        <source>the strokes span %1 × %2 units; at most 1e6 are possible, scale them down</source>
        <translation>die Striche reichen über %1 × %2 Einheiten; höchstens 1e6 sind möglich, bitte verkleinern</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>a value has the wrong type</source>
        <translation>ein Wert hat den falschen Typ</translation>
    </message>
    <message>
        <source>the first chunk must be HEAD</source>
        <translation>der erste Block muss HEAD sein</translation>
    </message>
    <message>
        <source>there is more than one HEAD</source>
        <translation>es gibt mehr als einen HEAD</translation>
    </message>
    <message>
        <source>there is more than one</source>
        <translation>es gibt mehr als einen</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse</source>
        <translation>Block %1 bei Byte %2 ist unbekannt, und das Bild braucht ihn; bitte Suffuse aktualisieren</translation>
    </message>
    <message>
        <source>is not a CBOR map</source>
        <translation>ist keine CBOR-Tabelle</translation>
    </message>
    <message>
        <source>lacks the version or the counts</source>
        <translation>es fehlen Version oder Anzahlen</translation>
    </message>
    <message>
        <source>was written by a newer program (%1): it needs a reader of version %2, this one is %3; update Suffuse</source>
        <translation>stammt von einem neueren Programm (%1): braucht einen Leser der Version %2, dieser hat %3; bitte Suffuse aktualisieren</translation>
    </message>
    <message>
        <source>the chunk DOCU is missing; the file is damaged, take a backup copy</source>
        <translation>der Block DOCU fehlt; die Datei ist beschädigt, bitte eine Sicherung nehmen</translation>
    </message>
    <message>
        <source>should hold %1 strokes and %2 segments, but holds %3 and %4; the file is damaged, take a backup copy</source>
        <translation>sollte %1 Striche und %2 Segmente enthalten, enthält aber %3 und %4; die Datei ist beschädigt, bitte eine Sicherung nehmen</translation>
    </message>
    <message>
        <source>the file is damaged, take a backup copy</source>
        <translation>die Datei ist beschädigt, bitte eine Sicherung nehmen</translation>
    </message>
    <message>
        <source>is not a .suffuse file</source>
        <translation>ist keine .suffuse-Datei</translation>
    </message>
    <message>
        <source>the hash of the whole differs</source>
        <translation>der Hash des Ganzen stimmt nicht</translation>
    </message>
    <message>
        <source>%1 bytes follow after the end</source>
        <translation>%1 Bytes folgen nach dem Ende</translation>
    </message>
    <message>
        <source>has %1 bytes, but the file only %2 more</source>
        <translation>hat %1 Bytes, die Datei aber nur noch %2</translation>
    </message>
    <message>
        <source>checksum differs</source>
        <translation>die Prüfsumme stimmt nicht</translation>
    </message>
    <message>
        <source>%1 strokes and %2 segments are more than the file can hold</source>
        <translation>%1 Striche und %2 Segmente sind mehr, als die Datei enthalten kann</translation>
    </message>
    <message>
        <source>its columns are not what the format allows</source>
        <translation>seine Spalten entsprechen nicht dem Format</translation>
    </message>
    <message>
        <source>stroke %1 of it is not what the format allows</source>
        <translation>Strich %1 darin entspricht nicht dem Format</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>“%1” is none of: %2</source>
        <translation>„%1“ ist keines von: %2</translation>
    </message>
    <message>
        <source>has %1 numbers; the kind %2 has %3</source>
        <translation>hat %1 Zahlen; die Art %2 hat %3</translation>
    </message>
    <message>
        <source>belongs to the mode beta; remove it or change the mode</source>
        <translation>gehört zum Modus beta; bitte entfernen oder den Modus ändern</translation>
    </message>
    <message>
        <source>has %1 points instead of 4</source>
        <translation>hat %1 Punkte statt 4</translation>
    </message>
    <message>
        <source>has %1 numbers instead of 2</source>
        <translation>hat %1 Zahlen statt 2</translation>
    </message>
    <message>
        <source>0 is not an id; count from 1 or leave it out</source>
        <translation>0 ist keine Kennung; bitte ab 1 zählen oder weglassen</translation>
    </message>
    <message>
        <source>%1 is not in [0, 4294967295]</source>
        <translation>%1 liegt nicht in [0, 4294967295]</translation>
    </message>
    <message>
        <source>width and height must not be negative</source>
        <translation>Breite und Höhe dürfen nicht negativ sein</translation>
    </message>
    <message>
        <source>%1 is not in [0, 1]</source>
        <translation>%1 liegt nicht in [0, 1]</translation>
    </message>
    <message>
        <source>“%1” is not “suffuse-text”</source>
        <translation>„%1“ ist nicht „suffuse-text“</translation>
    </message>
    <message>
        <source>0 is not a version; write 1</source>
        <translation>0 ist keine Version; bitte 1 schreiben</translation>
    </message>
    <message>
        <source>%1 is not a version that this program reads; it reads 1</source>
        <translation>%1 ist keine Version, die dieses Programm liest; es liest 1</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input; keep one of them</source>
        <translation>eine andere Kurve hat dieselbe Kenngröße und Eingabe; bitte nur eine behalten</translation>
    </message>
    <message>
        <source>needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>braucht 2 bis 16 Punkte [x, y] in [0, 1], von links nach rechts</translation>
    </message>
    <message>
        <source>could not be opened: %1</source>
        <translation>konnte nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>has more than 1 MB; it is not a brush</source>
        <translation>hat mehr als 1 MB; das ist kein Pinsel</translation>
    </message>
    <message>
        <source>a colour has three numbers: red, green, blue</source>
        <translation>eine Farbe hat drei Zahlen: Rot, Grün, Blau</translation>
    </message>
    <message>
        <source>“%1” is not a number from 0 to 255</source>
        <translation>„%1“ ist keine Zahl von 0 bis 255</translation>
    </message>
    <message>
        <source>is larger than 1 MiB; a palette is not</source>
        <translation>ist größer als 1 MiB; das ist eine Palette nie</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>“GIMP Palette” is missing: this is no GIMP palette</source>
        <translation>„GIMP Palette“ fehlt: Dies ist keine GIMP-Palette</translation>
    </message>
    <message>
        <source>there are more than %1 colours</source>
        <translation>es sind mehr als %1 Farben</translation>
    </message>
    <message>
        <source>has no settings; it is not a brush</source>
        <translation>hat keine Einstellungen; das ist kein Pinsel</translation>
    </message>
    <message>
        <source>is write-protected; save under another name or change its permissions</source>
        <translation>ist schreibgeschützt; bitte unter anderem Namen speichern oder die Rechte ändern</translation>
    </message>
    <message>
        <source>belongs to %1, and would not any more; save under another name</source>
        <translation>gehört %1 und würde es dann nicht mehr; bitte unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>could not be brought to the disk</source>
        <translation>konnte nicht auf den Datenträger gebracht werden</translation>
    </message>
    <message>
        <source>the backup could not be made; check the folder</source>
        <translation>die Sicherungskopie konnte nicht angelegt werden; bitte den Ordner prüfen</translation>
    </message>
    <message>
        <source>the first element is not curve_set</source>
        <translation>das erste Element ist nicht curve_set</translation>
    </message>
    <message>
        <source>%1 of %2 is &quot;%3&quot;, not a number up to 1e6</source>
        <translation>%1 von %2 ist „%3“, keine Zahl bis 1e6</translation>
    </message>
    <message>
        <source>a curve has %1 control points; 3n + 1 make cubics</source>
        <translation>eine Kurve hat %1 Kontrollpunkte; kubische brauchen 3n + 1</translation>
    </message>
    <message>
        <source>a curve has no colours on one of its sides</source>
        <translation>eine Kurve hat auf einer Seite keine Farben</translation>
    </message>
    <message>
        <source>has more than 64 MB of XML; that is more than is read</source>
        <translation>hat mehr als 64 MB XML; so viel wird nicht gelesen</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to paint</source>
        <translation>enthält keine Kurven; es gibt nichts zu malen</translation>
    </message>
    <message>
        <source>Diffusion curves (XML)</source>
        <translation>Diffusionskurven (XML)</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>er ist beschädigt</translation>
    </message>
    <message>
        <source>it belongs to another painting</source>
        <translation>er gehört zu einem anderen Bild</translation>
    </message>
    <message>
        <source>it has too many steps</source>
        <translation>er hat zu viele Schritte</translation>
    </message>
    <message>
        <source>step %1 is damaged</source>
        <translation>Schritt %1 ist beschädigt</translation>
    </message>
    <message>
        <source>step %1 does not fit the painting</source>
        <translation>Schritt %1 passt nicht zum Bild</translation>
    </message>
    <message>
        <source>the undo history was left out: %1</source>
        <translation>die Rückgängig-Schritte wurden weggelassen: %1</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2: %3</source>
        <translation>Block %1 bei Byte %2: %3</translation>
    </message>
    <message>
        <source>is cut off after %1 bytes</source>
        <translation>ist nach %1 Byte abgeschnitten</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>Byte %1: %2</translation>
    </message>
    <message>
        <source>is damaged, and nothing in it is whole (%1); take a backup copy</source>
        <translation>ist beschädigt, und nichts darin ist heil (%1); bitte eine Sicherungskopie nehmen</translation>
    </message>
    <message>
        <source>the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one</source>
        <translation>Leinwand, Papier, Gruppen, Farbfelder und Vorlage fehlen; die Leinwand ist eine übliche</translation>
    </message>
    <message>
        <source>the image of the paper is missing; there is no paper now</source>
        <translation>das Bild des Papiers fehlt; es gibt jetzt kein Papier</translation>
    </message>
    <message>
        <source>the underlay is missing</source>
        <translation>die Vorlage fehlt</translation>
    </message>
    <message>
        <source>%1 strokes with %2 segments are here; how many there were is not known</source>
        <translation>%1 Striche mit %2 Segmenten sind da; wie viele es waren, ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 of %2 strokes are missing, with %3 of %4 segments</source>
        <translation>%1 von %2 Strichen fehlen, mit %3 von %4 Segmenten</translation>
    </message>
    <message>
        <source>all %1 strokes are here</source>
        <translation>alle %1 Striche sind da</translation>
    </message>
    <message>
        <source>%1 strokes are in no group any more</source>
        <translation>%1 Striche gehören zu keiner Gruppe mehr</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>das Ende der Datei fehlt</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>das Journal kann nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>is not a journal of Suffuse</source>
        <translation>ist kein Journal von Suffuse</translation>
    </message>
    <message>
        <source>ends before its first painting was written</source>
        <translation>endet, bevor das erste Bild geschrieben war</translation>
    </message>
    <message>
        <source>was written by a newer program (%1); update Suffuse</source>
        <translation>wurde von einem neueren Programm (%1) geschrieben; bitte Suffuse aktualisieren</translation>
    </message>
    <message>
        <source>Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)</source>
        <translation>Suffuse liest .suffuse, seine Textform (.json), Stiftdaten als CSV, Universal Ink, InkML, Excalidraw, MyPaint-Ereignisse, Xournal++, Rnote, SVG und Diffusionskurven (XML)</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down</source>
        <translation>die Zeichnung ist %1 × %2 Einheiten groß; höchstens 1e6 sind möglich, verkleinern Sie sie</translation>
    </message>
    <message>
        <source>holds no paths that can be painted; in the program that drew it, turn text and images into paths first</source>
        <translation>enthält keine Pfade, die gemalt werden können; wandeln Sie Text und Bilder im Zeichenprogramm zuerst in Pfade um</translation>
    </message>
    <message>
        <source>the preview</source>
        <translation>die Vorschau</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>wie es zuletzt betrachtet wurde</translation>
    </message>
    <message>
        <source>the undo history</source>
        <translation>die Rückgängig-Schritte</translation>
    </message>
    <message>
        <source>the end of the file is damaged</source>
        <translation>das Ende der Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at byte %1</source>
        <translation>die Datei ist bei Byte %1 beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>Damaged and left out: %1. All %2 strokes are here.</source>
        <translation>Beschädigt und weggelassen: %1. Alle %2 Striche sind da.</translation>
    </message>
    <message>
        <source>damaged and left out: %1</source>
        <translation>beschädigt und weggelassen: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>%n nicht freihändig gezeichnetes Element</numerusform>
            <numerusform>%n nicht freihändig gezeichnete Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>column “%1”</source>
        <translation>Spalte „%1“</translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>%n Pinselform</numerusform>
            <numerusform>%n Pinselformen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>%n gedrehte oder gestreckte Pinselspitze</numerusform>
            <numerusform>%n gedrehte oder gestreckte Pinselspitzen</numerusform>
        </translation>
    </message>
    <message>
        <source>the pen&apos;s azimuths</source>
        <translation>die Azimute des Stifts</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>%n Ansicht erkannten Texts</numerusform>
            <numerusform>%n Ansichten erkannten Texts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>%1 wurde weggelassen.</numerusform>
            <numerusform>%1 wurden weggelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>list</comment>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>%n Farbverlauf</numerusform>
            <numerusform>%n Farbverläufe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>%n Muster</numerusform>
            <numerusform>%n Muster</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>%n Beschneidungspfad</numerusform>
            <numerusform>%n Beschneidungspfade</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>%n Maske</numerusform>
            <numerusform>%n Masken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>%n Filter</numerusform>
            <numerusform>%n Filter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>%n Mischmodus</numerusform>
            <numerusform>%n Mischmodi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n Markierung</numerusform>
            <numerusform>%n Markierungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>%n zu verwickelter Umriss</numerusform>
            <numerusform>%n zu verwickelte Umrisse</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n Text</numerusform>
            <numerusform>%n Texte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>%n Stilregel</numerusform>
            <numerusform>%n Stilregeln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>%n &lt;use&gt; seiner selbst</numerusform>
            <numerusform>%n &lt;use&gt; ihrer selbst</numerusform>
        </translation>
    </message>
    <message>
        <source>There is more in the drawing than is read; the rest was left out.</source>
        <translation>Die Zeichnung enthält mehr, als gelesen wird; der Rest wurde weggelassen.</translation>
    </message>
    <message>
        <source>ends after %1 bytes</source>
        <translation>endet nach %1 Bytes</translation>
    </message>
    <message>
        <source>its line endings were changed on the way, transfer it as a binary file</source>
        <translation>ihre Zeilenenden wurden unterwegs verändert, bitte als Binärdatei übertragen</translation>
    </message>
    <message>
        <source>its first bytes are damaged</source>
        <translation>ihre ersten Bytes sind beschädigt</translation>
    </message>
    <message>
        <source>the first bytes of the file</source>
        <translation>die ersten Bytes der Datei</translation>
    </message>
    <message>
        <source>version: %1 does not know all that strokes have here; write %2</source>
        <translation>version: %1 kennt nicht alles, was Striche hier haben; schreiben Sie %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads up to version %2; update Suffuse</source>
        <translation>%1 ist neuer als dieses Programm, das bis Version %2 liest; bitte Suffuse aktualisieren</translation>
    </message>
    <message>
        <source>This file is empty: nothing was saved in it.</source>
        <translation>Diese Datei ist leer: Darin wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>This is UTF-16 text. Save it as UTF-8.</source>
        <translation>Das ist UTF-16-Text. Bitte als UTF-8 speichern.</translation>
    </message>
    <message>
        <source>This is a picture, not a painting. %1.</source>
        <translation>Das ist eine Bilddatei, kein gemaltes Bild. %1.</translation>
    </message>
    <message>
        <source>This is neither a painting nor a recording that can be read. %1. Other programs can export SVG.</source>
        <translation>Das ist weder ein gemaltes Bild noch eine Aufzeichnung, die gelesen werden kann. %1. Andere Programme können SVG exportieren.</translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>%n Füllung</numerusform>
            <numerusform>%n Füllungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Other fonts stand in for those that are not installed: %1.</source>
        <translation>Andere Schriften vertreten die, die nicht installiert sind: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>%n Text kam als Buchstaben an: Er lässt sich nicht neu eintippen.</numerusform>
            <numerusform>%n Texte kamen als Buchstaben an: Sie lassen sich nicht neu eintippen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>das Bild einer Bildebene fehlt</numerusform>
            <numerusform>die Bilder von %n Bildebenen fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: it has no list of its parts.</source>
        <translation>Diese OpenRaster-Datei ist beschädigt: Ihr fehlt das Verzeichnis ihrer Teile.</translation>
    </message>
    <message>
        <source>OpenRaster picture</source>
        <translation>OpenRaster-Bild</translation>
    </message>
    <message>
        <source>Another program changed this picture. What was opened is the painting as Suffuse exported it.</source>
        <translation>Ein anderes Programm hat dieses Bild geändert. Geöffnet wurde das Gemälde, wie Suffuse es exportiert hat.</translation>
    </message>
    <message>
        <source>The linked picture %1 is missing, and is not seen: put its file back, or link another one in the Inspector.</source>
        <translation>Das verknüpfte Bild %1 fehlt und ist nicht zu sehen: Bitte die Datei an ihren Platz legen oder im Inspektor eine andere verknüpfen.</translation>
    </message>
    <message>
        <source>The linked picture %1 has more than 64 MB, and is not seen.</source>
        <translation>Das verknüpfte Bild %1 hat mehr als 64 MB und ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>The linked picture %1 has changed since it was linked, and is not seen: link it anew in the Inspector.</source>
        <translation>Das verknüpfte Bild %1 wurde seit dem Verknüpfen geändert und ist nicht zu sehen: Bitte im Inspektor neu verknüpfen.</translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>So ist es auch mit einem weiteren Bild.</numerusform>
            <numerusform>So ist es auch mit %n weiteren Bildern.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file is compressed with gzip, and what is in it is neither an SVG nor a notebook of Xournal++ or Rnote. Unpack it first. %1.</source>
        <translation>Diese Datei ist mit gzip gepackt, und was darin ist, ist weder ein SVG noch ein Notizbuch von Xournal++ oder Rnote. Bitte erst entpacken. %1.</translation>
    </message>
    <message>
        <source>Another program has changed the drawing since Suffuse wrote it. It is opened as it is drawn now, not as the painting that is in it.</source>
        <translation>Ein anderes Programm hat die Zeichnung geändert, seit Suffuse sie geschrieben hat. Sie wird geöffnet, wie sie jetzt gezeichnet ist, nicht als das Bild, das in ihr steckt.</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>is too large once it is unpacked</source>
        <translation>ist entpackt zu groß</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>ist beschädigt: lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>the colour profile</source>
        <translation>das Farbprofil</translation>
    </message>
    <message>
        <source>the size on paper</source>
        <translation>die Größe auf Papier</translation>
    </message>
    <message>
        <source>the first element is not xournal</source>
        <translation>das erste Element ist nicht xournal</translation>
    </message>
    <message>
        <source>holds no pages</source>
        <translation>enthält keine Seiten</translation>
    </message>
    <message>
        <source>%1 is no number within ±1e7</source>
        <translation>%1 ist keine Zahl innerhalb ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 layers</source>
        <translation>hat mehr als %1 Ebenen</translation>
    </message>
    <message>
        <source>the page has no size</source>
        <translation>die Seite hat keine Größe</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>the stroke has an x without y</source>
        <translation>der Strich hat ein x ohne y</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>hat mehr als %1 Punkte</translation>
    </message>
    <message>
        <source>the stroke has no width</source>
        <translation>der Strich hat keine Breite</translation>
    </message>
    <message>
        <source>%1: %2 is no number within ±1e7</source>
        <translation>%1: %2 ist keine Zahl innerhalb ±1e7</translation>
    </message>
    <message>
        <source>Xournal++ notebook</source>
        <translation>Xournal++-Notizbuch</translation>
    </message>
    <message>
        <source>InkML recording</source>
        <translation>InkML-Aufzeichnung</translation>
    </message>
    <message>
        <source>Rnote notebook</source>
        <translation>Rnote-Notizbuch</translation>
    </message>
    <message>
        <source>the first element is not ink</source>
        <translation>das erste Element ist nicht ink</translation>
    </message>
    <message>
        <source>its groups are too deep</source>
        <translation>seine Gruppen sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>a point has more than %1 values</source>
        <translation>ein Punkt hat mehr als %1 Werte</translation>
    </message>
    <message>
        <source>the trace is not a list of points with %1 numbers each, or there are more than %2 points</source>
        <translation>die Spur ist keine Liste von Punkten mit je %1 Zahlen, oder es sind mehr als %2 Punkte</translation>
    </message>
    <message>
        <source>the trace has no X and Y</source>
        <translation>die Spur hat kein X und Y</translation>
    </message>
    <message>
        <source>a point is farther than 1e7 units away</source>
        <translation>ein Punkt ist weiter als 1e7 Einheiten entfernt</translation>
    </message>
    <message>
        <source>holds no notebook that can be read; save it with Rnote 0.5 or later</source>
        <translation>enthält kein lesbares Notizbuch; bitte mit Rnote 0.5 oder neuer speichern</translation>
    </message>
    <message>
        <source>a point is not two numbers within ±1e7</source>
        <translation>ein Punkt besteht nicht aus zwei Zahlen innerhalb von ±1e7</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>hat mehr als %1 Zahlen</translation>
    </message>
    <message>
        <source>is Universal Ink %1.%2; 3.0 and 3.1 can be read</source>
        <translation>ist Universal Ink %1.%2; gelesen werden 3.0 und 3.1</translation>
    </message>
    <message>
        <source>is damaged: a part of it is not whole</source>
        <translation>ist beschädigt: Ein Teil ist nicht vollständig</translation>
    </message>
    <message>
        <source>its part %1 is packed in a way that cannot be read</source>
        <translation>sein Teil %1 ist auf eine Weise gepackt, die nicht gelesen werden kann</translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>%n Linienart</numerusform>
            <numerusform>%n Linienarten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n Form</numerusform>
            <numerusform>%n Formen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>%n Weg des Stifts über dem Papier</numerusform>
            <numerusform>%n Wege des Stifts über dem Papier</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>%n Abbildung von Kanälen</numerusform>
            <numerusform>%n Abbildungen von Kanälen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>%n Tonaufnahme</numerusform>
            <numerusform>%n Tonaufnahmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>%n liniertes oder bedrucktes Papier</numerusform>
            <numerusform>%n linierte oder bedruckte Papiere</numerusform>
        </translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone</source>
        <translation>ein Teil von Suffuse, %1, %2; Suffuse neu installieren. Er ist nur für PDF-Dateien da</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>lässt sich nicht laden (%1)</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>gehört zu einer anderen Version von Suffuse</translation>
    </message>
    <message>
        <source>would have more than 2 GB</source>
        <translation>hätte mehr als 2 GB</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>ließ sich nicht schreiben: %1</translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>Von %n Gemälde in dieser PDF-Datei wurde das erste geöffnet.</numerusform>
            <numerusform>Von %n Gemälden in dieser PDF-Datei wurde das erste geöffnet.</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>PDF-Datei</translation>
    </message>
    <message>
        <source>This is a PDF file, and %1.</source>
        <translation>Das ist eine PDF-Datei, und %1.</translation>
    </message>
    <message>
        <source>This PDF file is damaged: %1.</source>
        <translation>Diese PDF-Datei ist beschädigt: %1.</translation>
    </message>
    <message>
        <source>This PDF file holds no painting. Suffuse opens those that it wrote; open a picture of its pages as a layer instead.</source>
        <translation>Diese PDF-Datei enthält kein Gemälde. Suffuse öffnet die, die es geschrieben hat; stattdessen ein Bild ihrer Seiten als Ebene öffnen.</translation>
    </message>
    <message>
        <source>Another program changed this PDF file. What was opened is the painting as Suffuse exported it.</source>
        <translation>Ein anderes Programm hat diese PDF-Datei geändert. Geöffnet wurde das Gemälde, wie Suffuse es exportiert hat.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupCells</name>
    <message>
        <source>Clipped to what lies below it in its group</source>
        <translation>Beschnitten auf das, was in ihrer Gruppe darunterliegt</translation>
    </message>
    <message>
        <source>A mask for the others in its group</source>
        <translation>Eine Maske für die anderen in ihrer Gruppe</translation>
    </message>
    <message>
        <source>A wash: its strokes are one</source>
        <translation>Eine Lavierung: Ihre Striche sind einer</translation>
    </message>
    <message>
        <source>Shown alone</source>
        <translation>Wird allein gezeigt</translation>
    </message>
    <message>
        <source>A draft: left out of what is exported</source>
        <translation>Ein Entwurf: wird nicht exportiert</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupHand</name>
    <message>
        <source>The group is locked: nothing changes.</source>
        <translation>Die Gruppe ist gesperrt: Nichts ändert sich.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Deckkraft der Gruppe ändern</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Modus der Gruppe ändern</translation>
    </message>
    <message>
        <source>Opacity of the group</source>
        <translation>Deckkraft der Gruppe</translation>
    </message>
</context>
<context>
    <name>suffuse::HintLabel</name>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>suffuse::HistoryPanel</name>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Every change since the painting was opened. Click one to go back or forward to it.</source>
        <translation>Jede Änderung seit dem Öffnen. Ein Klick geht dorthin zurück oder vor.</translation>
    </message>
    <message>
        <source>This stroke</source>
        <translation>Dieser Strich</translation>
    </message>
</context>
<context>
    <name>suffuse::Importing</name>
    <message>
        <source>Picture to Strokes</source>
        <translation>Bild in Striche umwandeln</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Vorlage importieren</translation>
    </message>
    <message>
        <source>Import Strokes</source>
        <translation>Striche importieren</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was imported.</source>
        <translation>„%1“ ist beschädigt. Was davon heil ist, wurde importiert.</translation>
    </message>
    <message>
        <source>Import picture as layer</source>
        <translation>Bild als Ebene importieren</translation>
    </message>
    <message>
        <source>Add as &amp;Layer</source>
        <translation>Als &amp;Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Use as &amp;Underlay</source>
        <translation>Als &amp;Vorlage verwenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message>
        <source>Nothing is selected. Click a stroke to see and change its values.</source>
        <translation>Nichts ist ausgewählt. Ein Klick auf einen Strich zeigt seine Werte, die sich ändern lassen.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln Segment</numerusform>
            <numerusform>%Ln Segmente</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke…</source>
        <translation>Entlang des Strichs …</translation>
    </message>
    <message>
        <source>Sets a value along the stroke: constant, as a ramp, or drawn as a curve.</source>
        <translation>Setzt einen Wert entlang des Strichs: konstant, als Rampe oder als gezeichnete Kurve.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%1 von %Ln Segment</numerusform>
            <numerusform>%1 von %Ln Segmenten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>%Ln radierendes Segment</numerusform>
            <numerusform>%Ln radierende Segmente</numerusform>
        </translation>
    </message>
    <message>
        <source>They make paint paler.</source>
        <translation>Sie machen Farbe blasser.</translation>
    </message>
    <message>
        <source>They take paint away: the more density, the more.</source>
        <translation>Sie nehmen Farbe weg: je mehr Dichte, desto mehr.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>%Ln davon nimmt Farbe weg.</numerusform>
            <numerusform>%Ln davon nehmen Farbe weg.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KeyboardFocus</name>
    <message>
        <source>The %1 dock has the keyboard; Esc gives it back to the canvas.</source>
        <translation>Das Dock „%1“ hat die Tastatur; Esc gibt sie der Leinwand zurück.</translation>
    </message>
    <message>
        <source>The canvas has the keyboard.</source>
        <translation>Die Leinwand hat die Tastatur.</translation>
    </message>
    <message>
        <source>The tool bar “%1” has the keyboard; Esc gives it back to the canvas.</source>
        <translation>Die Werkzeugleiste „%1“ hat die Tastatur; Esc gibt sie der Leinwand zurück.</translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message>
        <source>Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.</source>
        <translation>Ziehen einer Linie fügt Knoten ein, wo sie Striche kreuzt. Umschalt: Striche zerschneiden. Strg: Schritte von 15°.</translation>
    </message>
    <message>
        <source>Cut strokes</source>
        <translation>Striche zerschneiden</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Knoten einfügen</translation>
    </message>
    <message>
        <source>%1 cut into %2</source>
        <extracomment>what the knife did; %1: &quot;2 strokes&quot;, %2: &quot;5 parts&quot;</extracomment>
        <translation>%1 in %2 zerschnitten</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln Teil</numerusform>
            <numerusform>%Ln Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inserted in %2</source>
        <extracomment>what the knife did; %1: &quot;3 nodes&quot;, %2: &quot;2 strokes&quot;</extracomment>
        <translation>%1 in %2 eingefügt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>%Ln Knoten</numerusform>
            <numerusform>%Ln Knoten</numerusform>
        </translation>
    </message>
    <message>
        <source>There are nodes already where the line crosses strokes.</source>
        <translation>Wo die Linie Striche kreuzt, sind schon Knoten.</translation>
    </message>
    <message>
        <source>The line crosses no stroke.</source>
        <translation>Die Linie kreuzt keinen Strich.</translation>
    </message>
    <message>
        <source>The line crosses no selected stroke.</source>
        <translation>Die Linie kreuzt keinen ausgewählten Strich.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Strichen</numerusform>
        </translation>
    </message>
    <message>
        <source>A fill is cut only where the line goes all the way through it.</source>
        <translation>Eine Füllung wird nur geschnitten, wo die Linie ganz durch sie hindurchgeht.</translation>
    </message>
    <message>
        <source>Inserts nodes where a line crosses strokes; with Shift it cuts them apart there.</source>
        <translation>Fügt Knoten ein, wo eine Linie Striche kreuzt; mit Umschalt trennt es sie dort.</translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message>
        <source>Tool Options</source>
        <translation>Werkzeugeinstellungen</translation>
    </message>
</context>
<context>
    <name>suffuse::MixingSection</name>
    <message>
        <source>Mixing</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>Paint colours over each other here. Shift+drag rubs, Ctrl+click picks.</source>
        <translation>Hier Farben übereinandermalen. Umschalt+Ziehen verreibt, Strg+Klick nimmt auf.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paints with the current colour.</source>
        <translation>Malt mit der aktuellen Farbe.</translation>
    </message>
    <message>
        <source>Rub</source>
        <translation>Verreiben</translation>
    </message>
    <message>
        <source>Carries the paint under the pointer along.</source>
        <translation>Nimmt die Farbe unter dem Zeiger mit.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Makes the colour under the pointer the current one.</source>
        <translation>Macht die Farbe unter dem Zeiger zur aktuellen.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Nimmt ein leeres Blatt.</translation>
    </message>
</context>
<context>
    <name>suffuse::MomentRow</name>
    <message>
        <source>Moment</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>All dried</source>
        <translation>Alles getrocknet</translation>
    </message>
    <message>
        <source>As it looks now</source>
        <translation>Wie es jetzt aussieht</translation>
    </message>
    <message>
        <source>At the time</source>
        <translation>Zum Zeitpunkt</translation>
    </message>
    <message>
        <source>The finished painting, the moment that the canvas shows, or any other.</source>
        <translation>Das fertige Gemälde, der Augenblick, den die Leinwand zeigt, oder jeder andere.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Minutes and seconds, as the timeline shows them: 1:02.345</source>
        <translation>Minuten und Sekunden, wie die Zeitleiste sie zeigt: 1:02.345</translation>
    </message>
</context>
<context>
    <name>suffuse::NewDialog</name>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Breite und Höhe tauschen</translation>
    </message>
    <message>
        <source>C&amp;reate</source>
        <translation>An&amp;legen</translation>
    </message>
    <message>
        <source>New Painting</source>
        <translation>Neues Bild</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Usual sizes, and sheets with a ground of their own</source>
        <translation>Übliche Größen, und Blätter mit eigenem Grund</translation>
    </message>
    <message>
        <source>Sides in</source>
        <translation>Seiten in</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>What width and height are given in. A pixel is a unit of the canvas.</source>
        <translation>Worin Breite und Höhe angegeben werden. Ein Pixel ist eine Einheit der Leinwand.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels for each inch of paper. The sheet stays as large on paper.</source>
        <translation>Pixel für jeden Zoll Papier. Auf Papier bleibt das Blatt so groß.</translation>
    </message>
</context>
<context>
    <name>suffuse::NextNodeFields</name>
    <message>
        <source>X</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Where the next node is set, from the left. Return sets it, and so does a click</source>
        <translation>Wo der nächste Knoten gesetzt wird, von links. Die Eingabetaste setzt ihn, ein Klick ebenso</translation>
    </message>
    <message>
        <source>Y</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Where the next node is set, from the top. Return sets it, and so does a click</source>
        <translation>Wo der nächste Knoten gesetzt wird, von oben. Die Eingabetaste setzt ihn, ein Klick ebenso</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>From the last node to the next one. Return sets it, and so does a click</source>
        <translation>Vom letzten Knoten bis zum nächsten. Die Eingabetaste setzt ihn, ein Klick ebenso</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a click</source>
        <translation>Richtung vom letzten Knoten zum nächsten, im Uhrzeigersinn von rechts. Die Eingabetaste setzt ihn, ein Klick ebenso</translation>
    </message>
    <message>
        <source>Close</source>
        <extracomment>closes an outline</extracomment>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the outline at its first node (Shift+Return)</source>
        <translation>Schließt den Umriss an seinem ersten Knoten (Umschalt+Eingabe)</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeCommands</name>
    <message>
        <source>The joined stroke has the upper one&apos;s fill. Undo brings the other back.</source>
        <translation>Der verbundene Strich hat die Füllung des oberen. Rückgängig bringt die andere zurück.</translation>
    </message>
    <message>
        <source>The joined stroke has no fill, as the upper one had none. Undo brings the lower one&apos;s back.</source>
        <translation>Der verbundene Strich hat keine Füllung, da der obere keine hatte. Rückgängig bringt die des unteren zurück.</translation>
    </message>
    <message>
        <source>Smooth nodes</source>
        <translation>Knoten glätten</translation>
    </message>
    <message>
        <source>Symmetric nodes</source>
        <translation>Knoten symmetrisch machen</translation>
    </message>
    <message>
        <source>Corner nodes</source>
        <translation>Knoten eckig machen</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Knoten einfügen</translation>
    </message>
    <message>
        <source>Break stroke</source>
        <translation>Strich auftrennen</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Knoten verbinden</translation>
    </message>
    <message>
        <source>Reverse strokes</source>
        <translation>Striche umkehren</translation>
    </message>
    <message>
        <source>Delete nodes</source>
        <translation>Knoten löschen</translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Segmente löschen</translation>
    </message>
    <message>
        <source>Bridge segments</source>
        <translation>Segmente überbrücken</translation>
    </message>
    <message>
        <source>A node alone has no paint: select the nodes at both ends of a segment, or take the whole stroke with the Select tool.</source>
        <translation>Ein Knoten allein hat keine Farbe: die Knoten an beiden Enden eines Segments auswählen, oder mit „Auswahl“ den ganzen Strich.</translation>
    </message>
    <message>
        <source>The closed outline begins and ends at this node, so it has nothing more to break. Delete Segments (Ctrl+Del) opens it.</source>
        <translation>Der geschlossene Umriss beginnt und endet an diesem Knoten, hier ist nichts mehr zu trennen. „Segmente löschen“ (Strg+Entf) öffnet ihn.</translation>
    </message>
    <message>
        <source>Join needs two ends of strokes: select one, and Shift+click the other or drag around both.</source>
        <translation>Verbinden braucht zwei Enden von Strichen: eines auswählen und das andere mit Umschalt anklicken, oder um beide ziehen.</translation>
    </message>
    <message>
        <source>These two ends cannot be joined.</source>
        <translation>Diese beiden Enden lassen sich nicht verbinden.</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeTool</name>
    <message>
        <source>Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.</source>
        <translation>Ziehen am Anfasser biegt die Kurve. Umschalt: Knoten eckig machen. Strg: Schritte von 15°.</translation>
    </message>
    <message>
        <source>Insert node</source>
        <translation>Knoten einfügen</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>Knoten verschieben</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Knoten verschieben</translation>
    </message>
    <message>
        <source>Click a segment to select it, Shift+click for a run or another stroke&apos;s, Ctrl+click to add or remove one. Drag around nodes.</source>
        <translation>Klick wählt ein Segment, Umschalt+Klick eine Folge oder in anderen Strichen, Strg+Klick eines dazu oder weg. Ziehen umrahmt Knoten.</translation>
    </message>
    <message>
        <source>Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. Shift+click for more.</source>
        <translation>Ziehen verschiebt Knoten, weich innerhalb der Reichweite (Mausrad, Alt+Ziehen). Strg: entlang einer Achse, Strg+Alt: des Anfassers. Umschalt+Klick wählt weitere.</translation>
    </message>
    <message>
        <source>Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to select the segment.</source>
        <translation>Ziehen biegt die Kurve innerhalb der Reichweite (Mausrad, Alt+Ziehen). Doppelklick fügt einen Knoten ein. Klick wählt das Segment.</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>Radierung verschieben</translation>
    </message>
    <message>
        <source>Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.</source>
        <translation>Die Radierung verschieben: Sie nimmt weg, wo sie liegt. Strg: entlang einer Achse. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Drag to move the erasure. Click to select it in all strokes, again for its part in this one, again for a segment. Delete removes it.</source>
        <translation>Ziehen verschiebt die Radierung. Klick wählt sie in allen Strichen aus, noch einer ihren Teil in diesem, ein dritter ein Segment. „Löschen“ entfernt sie.</translation>
    </message>
    <message>
        <source>Move segments</source>
        <translation>Segmente verschieben</translation>
    </message>
    <message>
        <source>An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes the gradient away; Esc first, and Delete means the stroke.</source>
        <translation>Ein Ende eines Farbverlaufs wird nicht allein gelöscht. „Entfernen“ neben „Farbverlauf“ im Inspektor nimmt den Farbverlauf weg; nach Esc meint „Löschen“ den Strich.</translation>
    </message>
    <message>
        <source>What was selected is deleted; its strokes are merely shown. Click what else is to go, or take whole strokes with the Select tool.</source>
        <translation>Was ausgewählt war, ist gelöscht; seine Striche werden nur noch gezeigt. Anklicken, was noch weg soll, oder mit „Auswahl“ ganze Striche nehmen.</translation>
    </message>
</context>
<context>
    <name>suffuse::NumberField</name>
    <message>
        <source>“%1” is not a number. Sums such as 12*1.5 or +2 work too.</source>
        <translation>„%1“ ist keine Zahl. Auch Rechnungen wie 12*1.5 oder +2 gehen.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3 is possible.</source>
        <translation>%1 liegt außerhalb des Bereichs: Möglich ist %2 bis %3.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: this number has no unit.</source>
        <translation>„%1“ ist hier nicht möglich: Diese Zahl hat keine Einheit.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: the unit is %2.</source>
        <translation>„%1“ ist hier nicht möglich: Die Einheit ist %2.</translation>
    </message>
    <message>
        <source> u</source>
        <translation> E</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in</source>
        <translation> in</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> u²/s</source>
        <translation> E²/s</translation>
    </message>
    <message>
        <source>%1 is out of range: more than 0 and up to %2 is possible.</source>
        <translation>%1 liegt außerhalb des Bereichs: Möglich ist mehr als 0 und bis %2.</translation>
    </message>
    <message>
        <source>%1 is the most that is possible.</source>
        <translation>Mehr als %1 ist nicht möglich.</translation>
    </message>
    <message>
        <source>%1 is the least that is possible.</source>
        <translation>Weniger als %1 ist nicht möglich.</translation>
    </message>
</context>
<context>
    <name>suffuse::PanTool</name>
    <message>
        <source>Drag to move the canvas. The wheel zooms; R and drag turns.</source>
        <translation>Ziehen verschiebt die Leinwand. Das Rad zoomt; R und Ziehen dreht.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPad</name>
    <message>
        <source>Try your pen here.</source>
        <translation>Hier den Stift ausprobieren.</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPage</name>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>Hart</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>How hard the pen must be pressed, for all brushes.</source>
        <translation>Wie fest der Stift gedrückt werden muss, für alle Pinsel.</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>Nimmt ein leeres Blatt.</translation>
    </message>
    <message>
        <source>pressure of the pen →</source>
        <translation>Druck des Stifts →</translation>
    </message>
    <message>
        <source>↑ paints with</source>
        <translation>↑ malt mit</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>Druckkurve</translation>
    </message>
    <message>
        <source>Drag the points; click for another; drag one out to take it away.</source>
        <translation>Die Punkte ziehen; ein Klick fügt einen hinzu; Hinausziehen entfernt ihn.</translation>
    </message>
    <message>
        <source>Paint here with the brush in use; the dot on the curve is the pen&apos;s pressure.</source>
        <translation>Hier mit dem benutzten Pinsel malen; der Punkt auf der Kurve ist der Druck des Stifts.</translation>
    </message>
    <message>
        <source>Only the pen and the mouse paint; fingers move the view</source>
        <translation>Nur Stift und Maus malen; Finger bewegen die Ansicht</translation>
    </message>
    <message>
        <source>One finger moves the canvas, two zoom and turn it. Otherwise one finger paints.</source>
        <translation>Ein Finger verschiebt die Leinwand, zwei zoomen und drehen sie. Sonst malt ein Finger.</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Leeren</translation>
    </message>
</context>
<context>
    <name>suffuse::PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Format, depth, quality, resolution, size, area and moment under a name</source>
        <translation>Format, Farbtiefe, Qualität, Auflösung, Größe, Bereich und Zeitpunkt unter einem Namen</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Sichern …</translation>
    </message>
    <message>
        <source>Keep what is set here as a preset</source>
        <translation>Was hier eingestellt ist, als Vorgabe behalten</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Forget the chosen preset</source>
        <translation>Die gewählte Vorgabe vergessen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>There is a preset “%1”. Replace it?</source>
        <translation>Es gibt schon eine Vorgabe „%1“. Ersetzen?</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Vorgabe speichern</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>&amp;Drucken</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Prints the canvas's colour; without it the paint lies on the paper as it is.</source>
        <translation>Druckt die Farbe der Leinwand; ohne sie liegt die Farbe auf dem Papier, wie es ist.</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>In Datei drucken (PDF)</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Drucker</translation>
    </message>
    <message>
        <source>Where the page comes out</source>
        <translation>Wo die Seite herauskommt</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. A file can be printed elsewhere.</source>
        <translation>Auf diesem Rechner ist kein Drucker eingerichtet. Eine Datei lässt sich anderswo drucken.</translation>
    </message>
    <message>
        <source>The PDF file that is written: one page as large as the paper.</source>
        <translation>Die PDF-Datei, die geschrieben wird: eine Seite, so groß wie das Papier.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Exemplare</translation>
    </message>
    <message>
        <source>How often the page is printed</source>
        <translation>Wie oft die Seite gedruckt wird</translation>
    </message>
    <message>
        <source>%1 – %2 × %3 mm</source>
        <translation>%1 – %2 × %3 mm</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>So groß wie das Blatt</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>How the paper lies</source>
        <translation>Wie das Papier liegt</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>The size of the paper</source>
        <translation>Die Größe des Papiers</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Left margin</source>
        <translation>Linker Rand</translation>
    </message>
    <message>
        <source>Top margin</source>
        <translation>Oberer Rand</translation>
    </message>
    <message>
        <source>Right margin</source>
        <translation>Rechter Rand</translation>
    </message>
    <message>
        <source>Bottom margin</source>
        <translation>Unterer Rand</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>What stays empty at this edge of the paper</source>
        <translation>Was an dieser Kante des Papiers leer bleibt</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>Fit to the page</source>
        <translation>An die Seite angepasst</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>Tatsächliche Größe</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>Skaliert</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Of the actual size</source>
        <translation>Von der tatsächlichen Größe</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How large the picture lies on the paper</source>
        <translation>Wie groß das Bild auf dem Papier liegt</translation>
    </message>
    <message>
        <source>%1 dpi</source>
        <translation>%1 dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>How many dots an inch the picture is drawn with</source>
        <translation>Mit wie vielen Punkten je Zoll das Bild gezeichnet wird</translation>
    </message>
    <message>
        <source>Usual: %1 dpi</source>
        <translation>Üblich: %1 dpi</translation>
    </message>
    <message>
        <source>The printer's: %1 dpi</source>
        <translation>Die des Druckers: %1 dpi</translation>
    </message>
    <message>
        <source>The margins leave no room on the paper.</source>
        <translation>Die Ränder lassen auf dem Papier keinen Platz.</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 mm on the paper.</source>
        <translation>Das Bild misst auf dem Papier %1 × %2 mm.</translation>
    </message>
    <message>
        <source>What does not fit is cut off.</source>
        <translation>Was nicht passt, wird abgeschnitten.</translation>
    </message>
    <message>
        <source>PDF files</source>
        <translation>PDF-Dateien</translation>
    </message>
    <message>
        <source>“%1” is not there any more. Choose another printer.</source>
        <translation>„%1“ ist nicht mehr da. Wählen Sie einen anderen Drucker.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintJob</name>
    <message>
        <source>The page does not fit into memory.</source>
        <translation>Die Seite passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>There is no room for the page on the disk: %1</source>
        <translation>Auf der Platte ist kein Platz für die Seite: %1</translation>
    </message>
    <message>
        <source>The printer does not take the page. See whether it is there, or print to a file.</source>
        <translation>Der Drucker nimmt die Seite nicht an. Sehen Sie nach, ob er da ist, oder drucken Sie in eine Datei.</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintRows</name>
    <message>
        <source>Print size</source>
        <translation>Druckgröße</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Breite auf Papier</translation>
    </message>
    <message>
        <source>Width on paper; the height and the pixels follow.</source>
        <translation>Breite auf Papier; Höhe und Pixel folgen.</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>Höhe auf Papier</translation>
    </message>
    <message>
        <source>Height on paper; the width and the pixels follow.</source>
        <translation>Höhe auf Papier; Breite und Pixel folgen.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>Millimeter oder Zoll</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels an inch. PNG, TIFF, JPEG and EXR files say it.</source>
        <translation>Pixel je Zoll. PNG-, TIFF-, JPEG- und EXR-Dateien nennen sie.</translation>
    </message>
</context>
<context>
    <name>suffuse::ProbePanel</name>
    <message>
        <source>Rest the pointer on the painting: what it is made of there is listed here, and stays when you come here to click it.</source>
        <translation>Den Zeiger auf dem Bild ruhen lassen: Woraus es dort besteht, steht dann hier und bleibt, wenn Sie zum Anklicken herkommen.</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Dichte φ</translation>
    </message>
    <message>
        <source>Of strokes: share of the colour. Of segments: share of the stroke&apos;s density.</source>
        <translation>Bei Strichen: Anteil an der Farbe. Bei Segmenten: Anteil an der Dichte des Strichs.</translation>
    </message>
    <message>
        <source>Strokes under the pointer</source>
        <translation>Striche unter dem Zeiger</translation>
    </message>
    <message>
        <source>Density over the age</source>
        <translation>Dichte über dem Alter</translation>
    </message>
    <message>
        <source>The density of the chosen stroke at this place from when it was painted until it is dry. Dashed: the density from which it is seen.</source>
        <translation>Die Dichte des gewählten Strichs an dieser Stelle, vom Malen bis zum Trocknen. Gestrichelt: die Dichte, ab der er zu sehen ist.</translation>
    </message>
    <message>
        <source>%1, %2 · paper η %3</source>
        <translation>%1; %2 · Papier η %3</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>The topmost stroke comes first, with its share of the colour.</source>
        <translation>Der oberste Strich steht zuerst, mit seinem Anteil an der Farbe.</translation>
    </message>
</context>
<context>
    <name>suffuse::PushTool</name>
    <message>
        <source>Drag to push strokes along. [ and ] change the size.</source>
        <translation>Ziehen schiebt Striche mit. [ und ] ändern die Größe.</translation>
    </message>
    <message>
        <source>Drag to push the selected strokes along. [ and ] change the size.</source>
        <translation>Ziehen schiebt die gewählten Striche mit. [ und ] ändern die Größe.</translation>
    </message>
    <message>
        <source>Drag to turn strokes into the direction of the drag.</source>
        <translation>Ziehen richtet Striche in Zugrichtung aus.</translation>
    </message>
    <message>
        <source>Drag to turn the selected strokes into the direction of the drag.</source>
        <translation>Ziehen richtet die gewählten Striche in Zugrichtung aus.</translation>
    </message>
    <message>
        <source>Hold to pull strokes together. Shift: apart.</source>
        <translation>Halten rafft Striche zusammen. Umschalt: auseinander.</translation>
    </message>
    <message>
        <source>Hold to pull the selected strokes together. Shift: apart.</source>
        <translation>Halten rafft die gewählten Striche zusammen. Umschalt: auseinander.</translation>
    </message>
    <message>
        <source>Drag to roughen strokes.</source>
        <translation>Ziehen raut Striche auf.</translation>
    </message>
    <message>
        <source>Drag to roughen the selected strokes.</source>
        <translation>Ziehen raut die gewählten Striche auf.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Schieben</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Kämmen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Raffen</translation>
    </message>
    <message>
        <source>Roughen</source>
        <translation>Aufrauen</translation>
    </message>
    <message>
        <source>What the circle does to strokes</source>
        <translation>Was der Kreis mit Strichen tut</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How much of it one touch does; a pen&apos;s pressure takes from it</source>
        <translation>Wie viel eine Berührung bewirkt; der Druck des Stifts mindert es</translation>
    </message>
    <message>
        <source>Push strokes</source>
        <translation>Striche schieben</translation>
    </message>
    <message>
        <source>Comb strokes</source>
        <translation>Striche kämmen</translation>
    </message>
    <message>
        <source>Pinch strokes</source>
        <translation>Striche raffen</translation>
    </message>
    <message>
        <source>Roughen strokes</source>
        <translation>Striche aufrauen</translation>
    </message>
    <message>
        <source>Letters are left alone while nothing is selected. Select the text to change its letters.</source>
        <translation>Buchstaben bleiben, wie sie sind, solange nichts ausgewählt ist. Wählen Sie den Text aus, um seine Buchstaben zu verändern.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message>
        <source>Recolour Artwork</source>
        <translation>Bild umfärben</translation>
    </message>
    <message>
        <source>Colours of what is selected</source>
        <translation>Farben des Ausgewählten</translation>
    </message>
    <message>
        <source>Colours of the painting</source>
        <translation>Farben des Bildes</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>The colours with the most paint come first. Choose one, or several, and give it another colour: it changes everywhere.</source>
        <translation>Die Farben mit der meisten Malfarbe kommen zuerst. Eine oder mehrere auswählen und ihnen eine andere Farbe geben: Sie ändern sich überall.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>%n Farbe, die ähnlich aussieht</numerusform>
            <numerusform>%n Farben, die ähnlich aussehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB-Farbe als #rrggbb, #rgb oder wie in CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>Farbfelder</translation>
    </message>
    <message>
        <source>The swatches of the painting. Click: the chosen colour becomes this one.</source>
        <translation>Die Farbfelder des Bildes. Klick: Die ausgewählte Farbe wird zu dieser.</translation>
    </message>
    <message>
        <source>Keep differences</source>
        <translation>Unterschiede behalten</translation>
    </message>
    <message>
        <source>Colours that are one line in the list change together and stay different. Else they become the same.</source>
        <translation>Farben, die eine Zeile der Liste sind, ändern sich gemeinsam und bleiben verschieden. Sonst werden sie gleich.</translation>
    </message>
    <message>
        <source>Reset the Colour</source>
        <translation>Farbe zurücksetzen</translation>
    </message>
    <message>
        <source>Gives the chosen colours back what they were</source>
        <translation>Gibt den ausgewählten Farben zurück, was sie waren</translation>
    </message>
    <message>
        <source>All colours</source>
        <translation>Alle Farben</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Turns all hues around the colour wheel</source>
        <translation>Dreht alle Farbtöne auf dem Farbrad</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>100 %: as it is; 0 %: grey; more: more colourful</source>
        <translation>100 %: wie es ist; 0 %: grau; mehr: bunter</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Above 0 % nearer to white, below nearer to black</source>
        <translation>Über 0 % näher an Weiß, darunter näher an Schwarz</translation>
    </message>
    <message>
        <source>Map to the nearest swatches</source>
        <translation>Auf die nächsten Farbfelder abbilden</translation>
    </message>
    <message>
        <source>Each colour becomes the swatch of the painting that looks nearest</source>
        <translation>Jede Farbe wird zu dem Farbfeld des Bildes, das am ähnlichsten aussieht</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>„%1“ ist keine Farbe. Schreibweise: #rrggbb, zum Beispiel #2f6690.</translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message>
        <source>Recover Paintings</source>
        <translation>Bilder wiederherstellen</translation>
    </message>
    <message>
        <source>Suffuse ended before these paintings were saved. They open as they were at the last stroke; files on the disk are left as they are.</source>
        <translation>Suffuse endete, bevor diese Bilder gespeichert waren. Sie öffnen sich, wie sie beim letzten Strich waren; Dateien auf dem Datenträger bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Paintings that can be recovered</source>
        <translation>Bilder, die wiederhergestellt werden können</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Last Change</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Verwerfen …</translation>
    </message>
    <message>
        <source>Opens the selected paintings, without a file of their own</source>
        <translation>Öffnet die ausgewählten Bilder, ohne eigene Datei</translation>
    </message>
    <message>
        <source>Asks again when Suffuse starts the next time</source>
        <translation>Fragt beim nächsten Start von Suffuse wieder</translation>
    </message>
    <message>
        <source>Removes the selected paintings for good</source>
        <translation>Entfernt die ausgewählten Bilder endgültig</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Discard “%1”?</source>
        <translation>„%1“ verwerfen?</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>%n Bild verwerfen?</numerusform>
            <numerusform>%n Bilder verwerfen?</numerusform>
        </translation>
    </message>
    <message>
        <source>What was painted since the last save is then lost for good.</source>
        <translation>Was seit dem letzten Speichern gemalt wurde, ist dann endgültig verloren.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
</context>
<context>
    <name>suffuse::RedrawTool</name>
    <message>
        <source>Draw from a stroke and back to it: the part between follows the line.</source>
        <translation>Von einem Strich weg und zurück zeichnen: Der Teil dazwischen folgt der Linie.</translation>
    </message>
    <message>
        <source>Draw from a selected stroke and back to it: the part between follows.</source>
        <translation>Von einem gewählten Strich weg und zurück zeichnen: Der Teil dazwischen folgt.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>Wie sie waren</translation>
    </message>
    <message>
        <source>Of the brush in hand</source>
        <translation>Des Pinsels in der Hand</translation>
    </message>
    <message>
        <source>What the new part is painted with, and when</source>
        <translation>Womit und wann der neue Teil gemalt ist</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Neu zeichnen</translation>
    </message>
    <message>
        <source>The line begins and ends at no stroke that can be changed.</source>
        <translation>Die Linie beginnt und endet an keinem Strich, der geändert werden kann.</translation>
    </message>
    <message>
        <source>The line begins and ends at no selected stroke that can be changed.</source>
        <translation>Die Linie beginnt und endet an keinem gewählten Strich, der geändert werden kann.</translation>
    </message>
</context>
<context>
    <name>suffuse::ReshapeDialog</name>
    <message>
        <source>Reshape</source>
        <translation>Umformen</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>Grow or shrink</source>
        <translation>Verbreitern oder verschmälern</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versetzen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>How far curves may move</source>
        <translation>Wie weit Kurven wandern dürfen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>How far spreads, densities, colours and times may differ that become one</source>
        <translation>Wie weit Ausbreitung, Dichte, Farbe und Zeit dessen abweichen dürfen, was eins wird</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Wiggles of this length and shorter ones go</source>
        <translation>Wellen dieser Länge und kürzere verschwinden</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>0 %: as it is; 100 %: a straight line</source>
        <translation>0 %: wie es ist; 100 %: eine gerade Linie</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Of the paint; below 100 % it shrinks</source>
        <translation>Der Farbe; unter 100 % wird sie schmaler</translation>
    </message>
    <message>
        <source>To the right of the stroke&apos;s direction; below 0 to the left</source>
        <translation>Nach rechts von der Richtung des Strichs; unter 0 nach links</translation>
    </message>
    <message>
        <source>%1 → %2 segments</source>
        <extracomment>%1, %2: numbers of segments before and after</extracomment>
        <translation>%1 → %2 Segmente</translation>
    </message>
    <message>
        <source>%1, picture differs by %2</source>
        <extracomment>%1: &quot;12 → 3 segments&quot;; %2: &quot;0.4 %&quot;, the mean difference of the pictures</extracomment>
        <translation>%1, Bild weicht um %2 ab</translation>
    </message>
</context>
<context>
    <name>suffuse::RewetRows</name>
    <message>
        <source>Wetted again</source>
        <translation>Wieder angefeuchtet</translation>
    </message>
    <message>
        <source>… and more</source>
        <translation>… und mehr</translation>
    </message>
    <message>
        <source>at %1 for %2 s</source>
        <translation>bei %1 für %2 s</translation>
    </message>
    <message>
        <source>at %1 for %2 s, some segments</source>
        <translation>bei %1 für %2 s, einige Segmente</translation>
    </message>
    <message>
        <source>The selected paint is not wetted then</source>
        <translation>Die ausgewählte Farbe wird dann nicht angefeuchtet</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>Wiederanfeuchten aufheben</translation>
    </message>
</context>
<context>
    <name>suffuse::ScreenColourRows</name>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hellwert</translation>
    </message>
    <message>
        <source>Hue on the circle of the screen&apos;s colours: 0° red, 120° green, 240° blue</source>
        <translation>Farbton auf dem Kreis der Bildschirmfarben: 0° Rot, 120° Grün, 240° Blau</translation>
    </message>
    <message>
        <source>0 %: grey; 100 %: as colourful as a screen can be</source>
        <translation>0 %: grau; 100 %: so bunt, wie ein Bildschirm sein kann</translation>
    </message>
    <message>
        <source>0 %: black; 100 %: as bright as the colour can be</source>
        <translation>0 %: schwarz; 100 %: so hell, wie die Farbe sein kann</translation>
    </message>
    <message>
        <source>Red light of the screen, 0 to 255</source>
        <translation>Rotes Licht des Bildschirms, 0 bis 255</translation>
    </message>
    <message>
        <source>Green light of the screen, 0 to 255</source>
        <translation>Grünes Licht des Bildschirms, 0 bis 255</translation>
    </message>
    <message>
        <source>Blue light of the screen, 0 to 255</source>
        <translation>Blaues Licht des Bildschirms, 0 bis 255</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>suffuse::SegmentSection</name>
    <message>
        <source>Diffusion D</source>
        <translation>Diffusion D</translation>
    </message>
    <message>
        <source>How fast the paint spreads: the spread grows with the root of D times time.</source>
        <translation>Wie schnell die Farbe verläuft: Die Ausbreitung wächst mit der Wurzel aus D mal Zeit.</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>Dichte φ</translation>
    </message>
    <message>
        <source>How much paint the segment gives off along its length.</source>
        <translation>Wie viel Farbe das Segment entlang seiner Länge abgibt.</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Trockenzeit</translation>
    </message>
    <message>
        <source>t_max: how long the paint spreads after it was laid down.</source>
        <translation>t_max: wie lange die Farbe nach dem Auftragen verläuft.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Change diffusion</source>
        <translation>Diffusion ändern</translation>
    </message>
    <message>
        <source>Change density</source>
        <translation>Dichte ändern</translation>
    </message>
    <message>
        <source>Change granulation</source>
        <translation>Granulation ändern</translation>
    </message>
    <message>
        <source>Change drying time</source>
        <translation>Trockenzeit ändern</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Farbe der Auswahl</translation>
    </message>
    <message>
        <source>Colour of the selection. Click: paint with it.</source>
        <translation>Farbe der Auswahl. Klick: damit malen.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Direction of the anisotropy, clockwise from the horizontal.</source>
        <translation>Richtung der Anisotropie, im Uhrzeigersinn von der Waagerechten.</translation>
    </message>
    <message>
        <source>Change anisotropy</source>
        <translation>Anisotropie ändern</translation>
    </message>
    <message>
        <source>Change angle</source>
        <translation>Winkel ändern</translation>
    </message>
    <message>
        <source>How many times D along the angle is D across it; 1 spreads evenly.</source>
        <translation>Wievielmal so groß D längs des Winkels ist wie quer dazu; bei 1 breitet sich die Farbe gleichmäßig aus.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much the paint covers at full density</source>
        <translation>Wie stark die Farbe bei voller Dichte deckt</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Share of red pigment</source>
        <translation>Anteil des roten Pigments</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Share of yellow pigment</source>
        <translation>Anteil des gelben Pigments</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Share of blue pigment</source>
        <translation>Anteil des blauen Pigments</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für die ganze Auswahl möglich: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Entsteht</translation>
    </message>
    <message>
        <source>When the stroke, or what is selected of it, begins. All of that moves in time as one.</source>
        <translation>Wann der Strich, oder was von ihm ausgewählt ist, beginnt. All das verschiebt sich gemeinsam in der Zeit.</translation>
    </message>
    <message>
        <source>Change birth</source>
        <translation>Entstehung ändern</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Granulation</source>
        <translation>Granulation</translation>
    </message>
    <message>
        <source>How much of the paper&apos;s grain shows: 0 % is smooth, 100 % shows all of it. Files and scripts hold ω, which is 1 where this is 0 %.</source>
        <translation>Wie viel von der Körnung des Papiers zu sehen ist: 0 % ist glatt, 100 % zeigt sie ganz. Dateien und Skripte enthalten ω, das 1 ist, wo hier 0 % steht.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width of a dry line at full pressure, in units; sets the diffusion.</source>
        <translation>Breite einer trockenen Linie bei vollem Druck, in Einheiten; stellt die Diffusion ein.</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Density in the middle of the stroke at full pressure.</source>
        <translation>Dichte in der Mitte des Strichs bei vollem Druck.</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Schnur</translation>
    </message>
    <message>
        <source>Its length on the screen</source>
        <translation>Ihre Länge auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Pigment β</source>
        <translation>Pigment β</translation>
    </message>
    <message>
        <source>Share of the colour below that stays: 0 % covers, 100 % adds.</source>
        <translation>Anteil der unteren Farbe, der bleibt: 0 % deckt, 100 % addiert.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How deep the grain goes.</source>
        <translation>Wie tief die Körnung reicht.</translation>
    </message>
    <message>
        <source>How far the stroke lags behind</source>
        <translation>Wie weit der Strich zurückbleibt</translation>
    </message>
    <message>
        <source>Parameter of the style</source>
        <translation>Parameter des Stils</translation>
    </message>
    <message>
        <source>Threshold ξ1</source>
        <translation>Schwelle ξ1</translation>
    </message>
    <message>
        <source>Softness ξ2</source>
        <translation>Weichheit ξ2</translation>
    </message>
    <message>
        <source>Full at ξ1</source>
        <translation>Voll bei ξ1</translation>
    </message>
    <message>
        <source>Steepness ξ2</source>
        <translation>Steilheit ξ2</translation>
    </message>
    <message>
        <source>Edge ξ1</source>
        <translation>Rand ξ1</translation>
    </message>
    <message>
        <source>Lightening ξ2</source>
        <translation>Aufhellung ξ2</translation>
    </message>
    <message>
        <source>Strength ξ3</source>
        <translation>Stärke ξ3</translation>
    </message>
    <message>
        <source>Density at which the stroke covers by half.</source>
        <translation>Dichte, bei der der Strich zur Hälfte deckt.</translation>
    </message>
    <message>
        <source>How gently the edge fades.</source>
        <translation>Wie sanft der Rand ausläuft.</translation>
    </message>
    <message>
        <source>Density from which the stroke covers fully.</source>
        <translation>Dichte, ab der der Strich ganz deckt.</translation>
    </message>
    <message>
        <source>How steeply coverage grows with density.</source>
        <translation>Wie steil die Deckung mit der Dichte wächst.</translation>
    </message>
    <message>
        <source>Density at which the dark rim stands.</source>
        <translation>Dichte, bei der der dunkle Rand steht.</translation>
    </message>
    <message>
        <source>How much the inside is lighter than the rim; at most 1.26·ξ1.</source>
        <translation>Wie viel heller das Innere ist als der Rand; höchstens 1,26·ξ1.</translation>
    </message>
    <message>
        <source>Coverage far inside the stroke.</source>
        <translation>Deckung tief im Inneren des Strichs.</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Feathering</source>
        <translation>Weich auslaufend</translation>
    </message>
    <message>
        <source>Dark edges</source>
        <translation>Dunkle Ränder</translation>
    </message>
    <message>
        <source>Covering (alpha)</source>
        <translation>Deckend (Alpha)</translation>
    </message>
    <message>
        <source>Pigment (β)</source>
        <translation>Pigment (β)</translation>
    </message>
    <message>
        <source>Erasure</source>
        <translation>Radierung</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>Gewichtet</translation>
    </message>
    <message>
        <source>Pulled string</source>
        <translation>Gezogene Schnur</translation>
    </message>
</context>
<context>
    <name>suffuse::SelectTool</name>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.</source>
        <translation>Strich %1 von %2 unter dem Zeiger, von oben gezählt. Nochmals Alt+Klick: der nächste darunter.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>Scheren</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1: moved by %2, %3</source>
        <translation>%1: verschoben um %2, %3</translation>
    </message>
</context>
<context>
    <name>suffuse::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Colours of the windows</source>
        <translation>Farben der Fenster</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>All cores</source>
        <translation>Alle Kerne</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>Renderer</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungskopien</translation>
    </message>
    <message>
        <source>How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the last one, “~2” the one before. File ▸ Restore Backup brings one back.</source>
        <translation>Wie viele frühere Fassungen beim Speichern bleiben: „name.suffuse~“ daneben ist die letzte, „~2“ die davor. Datei ▸ Sicherungskopie wiederherstellen holt eine zurück.</translation>
    </message>
    <message>
        <source>Language of the program</source>
        <translation>Sprache des Programms</translation>
    </message>
    <message>
        <source>How the picture comes to the screen</source>
        <translation>Wie das Bild auf den Bildschirm kommt</translation>
    </message>
    <message>
        <source>What computes the picture</source>
        <translation>Was das Bild berechnet</translation>
    </message>
    <message>
        <source>Processor threads for drawing</source>
        <translation>Prozessor-Threads zum Zeichnen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Whether docks glide to their places and carets blink</source>
        <translation>Ob Andockfenster an ihren Platz gleiten und Textmarken blinken</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
</context>
<context>
    <name>suffuse::SheetView</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>suffuse::ShortcutsDialog</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut holds this text.</source>
        <translation>Zeigt nur Befehle, deren Name oder Kürzel diesen Text enthält.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Kürzel</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Choose a command, then press its new shortcut below.</source>
        <translation>Einen Befehl wählen, dann unten das neue Kürzel drücken.</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>Tasten drücken</translation>
    </message>
    <message>
        <source>No shortcut for this command</source>
        <translation>Kein Kürzel für diesen Befehl</translation>
    </message>
    <message>
        <source>This command&apos;s own shortcut</source>
        <translation>Das eigene Kürzel dieses Befehls</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” and “%3”. Give one of them another shortcut.</source>
        <translation>%1 gehört zu „%2“ und „%3“. Bitte einem von beiden ein anderes Kürzel geben.</translation>
    </message>
    <message>
        <source>Takes the shortcut away from the other command</source>
        <translation>Nimmt dem anderen Befehl das Tastenkürzel weg</translation>
    </message>
    <message>
        <source>Fixed: no command can have these keys.</source>
        <translation>Fest: Kein Befehl kann diese Tasten haben.</translation>
    </message>
    <message>
        <source>%1 is fixed: “%2”. Give “%3” another shortcut.</source>
        <translation>%1 ist fest: „%2“. Geben Sie „%3“ ein anderes Kürzel.</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keines</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>Ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there.</source>
        <translation>Wo das Kürzel wirkt. Was in einem Dock ohne Strg oder Alt getippt wird, bleibt dort.</translation>
    </message>
</context>
<context>
    <name>suffuse::SizedTool</name>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Diameter of the circle ([ and ] change it)</source>
        <translation>Durchmesser des Kreises ([ und ] ändern ihn)</translation>
    </message>
</context>
<context>
    <name>suffuse::SliderField</name>
    <message>
        <source>Double-click: back to the default.</source>
        <translation>Doppelklick: zurück zum Standardwert.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieberegler</translation>
    </message>
    <message>
        <source>The values differ. The slider multiplies each of them; with Ctrl it makes them one.</source>
        <translation>Die Werte sind verschieden. Der Regler vervielfacht jeden von ihnen; mit Strg macht er einen aus allen.</translation>
    </message>
    <message>
        <source>The values differ. The slider adds to each of them; with Ctrl it makes them one.</source>
        <translation>Die Werte sind verschieden. Der Regler erhöht oder senkt jeden von ihnen; mit Strg macht er einen aus allen.</translation>
    </message>
    <message>
        <source>The values differ. A number makes them one; *1.2 or +2 changes each of them.</source>
        <translation>Die Werte sind verschieden. Eine Zahl macht einen aus allen; *1,2 oder +2 ändert jeden von ihnen.</translation>
    </message>
</context>
<context>
    <name>suffuse::SoftReach</name>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How far along the stroke a dragged node or curve takes along what lies near; 0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)</source>
        <translation>Wie weit entlang des Strichs ein gezogener Knoten oder Bogen seine Umgebung mitnimmt; 0: nichts (Mausrad oder [ und ] beim Ziehen oder Alt+Ziehen ändern es)</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Let the reach follow the view: soft where nodes would crowd, else the node alone</source>
        <translation>Reichweite der Ansicht folgen lassen: weich, wo sich Knoten drängen würden, sonst der Knoten allein</translation>
    </message>
    <message>
        <source>Let the reach follow the view</source>
        <translation>Reichweite der Ansicht folgen lassen</translation>
    </message>
</context>
<context>
    <name>suffuse::StatusLine</name>
    <message>
        <source>Position of the pointer, in what the rulers count</source>
        <translation>Position des Zeigers, in der Einheit der Lineale</translation>
    </message>
    <message>
        <source>Zoom, and the angle by which the canvas is turned</source>
        <translation>Zoom und Drehwinkel der Leinwand</translation>
    </message>
    <message>
        <source>What renders the picture</source>
        <translation>Was das Bild berechnet</translation>
    </message>
    <message>
        <source>Time that the last frame took</source>
        <translation>Dauer des letzten Bildes</translation>
    </message>
    <message>
        <source>You paint in the past: what came later covers it.</source>
        <extracomment>instead of what the brush does, while the timeline shows a moment of the past</extracomment>
        <translation>Sie malen in der Vergangenheit: Späteres verdeckt es.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>a position: x, y</extracomment>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms, coarse</source>
        <translation>%1 ms, grob</translation>
    </message>
    <message>
        <source>Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and lifts it; + and - change its pressure; Esc puts it away.</source>
        <translation>Pfeiltasten bewegen den Stift, mit Umschalt weit und mit Alt fein; die Leertaste setzt ihn auf und hebt ihn ab; + und - ändern den Druck; Esc legt ihn weg.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeHistoryList</name>
    <message>
        <source>History of the selected stroke</source>
        <translation>Verlauf des ausgewählten Strichs</translation>
    </message>
    <message>
        <source>What was done to the selected stroke. Click a state to put this stroke back to it; everything else stays as it is.</source>
        <translation>Was mit dem ausgewählten Strich geschah. Ein Klick auf einen Zustand setzt diesen Strich dorthin zurück; alles andere bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>As it was at first</source>
        <translation>Wie er anfangs war</translation>
    </message>
    <message>
        <source>Put stroke back</source>
        <translation>Strich zurücksetzen</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeSection</name>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the selected strokes, as the list of strokes shows it.</source>
        <translation>Name der ausgewählten Striche, wie ihn die Strichliste zeigt.</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Strich umbenennen</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Wie sich die Farbe mit dem Darunterliegenden mischt: Sie deckt, oder Pigmente addieren sich.</translation>
    </message>
    <message>
        <source>Change pigment mixing</source>
        <translation>Pigmentmischung ändern</translation>
    </message>
    <message>
        <source>Change mixing</source>
        <translation>Mischung ändern</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für die ganze Auswahl möglich: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>The mixing of the wash is seen in place of this one.</source>
        <translation>Statt dieser Mischung ist die der Lavierung zu sehen.</translation>
    </message>
</context>
<context>
    <name>suffuse::WashRows</name>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>How the density of all strokes of the wash becomes coverage.</source>
        <translation>Wie aus der Dichte aller Striche der Lavierung Deckung wird.</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>How the wash mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>Wie sich die Lavierung mit dem mischt, was darunter liegt: Sie deckt, oder Pigmente summieren sich.</translation>
    </message>
    <message>
        <source>Change wash</source>
        <translation>Lavierung ändern</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>Nicht für alles Ausgewählte möglich: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Visible. Click: hide.</source>
        <translation>Sichtbar. Klick: ausblenden.</translation>
    </message>
    <message>
        <source>Hidden. Click: show.</source>
        <translation>Ausgeblendet. Klick: einblenden.</translation>
    </message>
    <message>
        <source>Locked. Click: unlock.</source>
        <translation>Gesperrt. Klick: entsperren.</translation>
    </message>
    <message>
        <source>Not locked. Click: lock.</source>
        <translation>Nicht gesperrt. Klick: sperren.</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln Segment</numerusform>
            <numerusform>%Ln Segmente</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>Strich umbenennen</translation>
    </message>
    <message>
        <source>Hide group</source>
        <translation>Gruppe ausblenden</translation>
    </message>
    <message>
        <source>Show group</source>
        <translation>Gruppe einblenden</translation>
    </message>
    <message>
        <source>Unlock group</source>
        <translation>Gruppe entsperren</translation>
    </message>
    <message>
        <source>Lock group</source>
        <translation>Gruppe sperren</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Strich ausblenden</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Strich einblenden</translation>
    </message>
    <message>
        <source>Unlock stroke</source>
        <translation>Strich entsperren</translation>
    </message>
    <message>
        <source>Lock stroke</source>
        <translation>Strich sperren</translation>
    </message>
    <message>
        <source>Reorder strokes</source>
        <translation>Striche umordnen</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>All in it is hidden. Click: show it.</source>
        <translation>Alles darin ist ausgeblendet. Klick: einblenden.</translation>
    </message>
    <message>
        <source>Some of it is hidden. Click: hide the group.</source>
        <translation>Ein Teil davon ist ausgeblendet. Klick: die Gruppe ausblenden.</translation>
    </message>
    <message>
        <source>All in it is locked. Click: unlock it.</source>
        <translation>Alles darin ist gesperrt. Klick: entsperren.</translation>
    </message>
    <message>
        <source>Some of it is locked. Click: lock the group.</source>
        <translation>Ein Teil davon ist gesperrt. Klick: die Gruppe sperren.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>%Ln Stück</numerusform>
            <numerusform>%Ln Stücke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>%Ln Radierung</numerusform>
            <numerusform>%Ln Radierungen</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between &quot;3 pieces&quot; and &quot;12 erasures&quot;</extracomment>
        <translation>, </translation>
    </message>
    <message>
        <source>mixes by itself</source>
        <translation>mischt für sich</translation>
    </message>
    <message>
        <source>%1, painted on</source>
        <translation>%1, hierauf wird gemalt</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesPanel</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search strokes</source>
        <translation>Striche suchen</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>The topmost stroke comes first. Drag to reorder, double-click to rename; a right click offers more.</source>
        <translation>Der oberste Strich steht zuerst. Ziehen ordnet um, Doppelklick benennt um; ein Rechtsklick bietet mehr.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Mo&amp;ve Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>Select rows to move them.</source>
        <translation>Wählen Sie die Zeilen aus, die Sie verschieben wollen.</translation>
    </message>
    <message>
        <source>Nothing changes: this is on top already.</source>
        <translation>Nichts ändert sich: das steht schon ganz oben.</translation>
    </message>
    <message>
        <source>Nothing changes: this is at the bottom already.</source>
        <translation>Nichts ändert sich: das steht schon ganz unten.</translation>
    </message>
    <message>
        <source>Nothing changes: locked strokes stay in place.</source>
        <translation>Nichts ändert sich: gesperrte Striche bleiben an ihrem Platz.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Select &amp;Same</source>
        <translation>&amp;Gleiche auswählen</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>&amp;Stil</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Einblenden</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>E&amp;ntsperren</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>Striche ausblenden</translation>
    </message>
    <message>
        <source>Show strokes</source>
        <translation>Striche einblenden</translation>
    </message>
    <message>
        <source>Unlock strokes</source>
        <translation>Striche entsperren</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>Striche sperren</translation>
    </message>
    <message>
        <source>Shows only strokes and groups whose name holds this text. Return selects them.</source>
        <translation>Zeigt nur Striche und Gruppen, deren Name diesen Text enthält. Die Eingabetaste wählt sie aus.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>No stroke is called “%1”.</source>
        <translation>Kein Strich heißt „%1“.</translation>
    </message>
    <message>
        <source>While the list is searched, rows are not dragged: between those that show there may be others. Clear the search first.</source>
        <translation>Während in der Liste gesucht wird, lassen sich keine Zeilen ziehen: Zwischen den gezeigten können andere liegen. Bitte zuerst die Suche leeren.</translation>
    </message>
    <message>
        <source>Mi&amp;x by Itself</source>
        <translation>Für sich &amp;mischen</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Gruppe für sich mischen</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Gruppe mit dem Bild darunter mischen</translation>
    </message>
    <message>
        <source>New layer: %1</source>
        <translation>Neue Ebene: %1</translation>
    </message>
    <message>
        <source>Painting on: %1</source>
        <translation>Gemalt wird auf: %1</translation>
    </message>
    <message>
        <source>The layer comes into the list with the first stroke that is painted.</source>
        <translation>Die Ebene kommt mit dem ersten Strich, der gemalt wird, in die Liste.</translation>
    </message>
    <message>
        <source>What is painted goes into this group. A click beside all rows: on top of all again.</source>
        <translation>Was gemalt wird, kommt in diese Gruppe. Klick neben alle Zeilen: wieder über alles.</translation>
    </message>
    <message>
        <source>Painting on top of all</source>
        <translation>Es wird über allem gemalt</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Modus</translation>
    </message>
    <message>
        <source>O&amp;pacity…</source>
        <translation>&amp;Deckkraft …</translation>
    </message>
    <message>
        <source>New clipped layer: %1</source>
        <translation>Neue begrenzte Ebene: %1</translation>
    </message>
</context>
<context>
    <name>suffuse::StyleSection</name>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Gehört zu</translation>
    </message>
    <message>
        <source>Whether the segments follow their stroke&apos;s style or have their own.</source>
        <translation>Ob die Segmente dem Stil ihres Strichs folgen oder einen eigenen haben.</translation>
    </message>
    <message>
        <source>The stroke</source>
        <translation>Dem Strich</translation>
    </message>
    <message>
        <source>These segments</source>
        <translation>Diesen Segmenten</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>Wie aus Dichte Deckung wird.</translation>
    </message>
    <message>
        <source>Change style</source>
        <translation>Stil ändern</translation>
    </message>
    <message>
        <source>Give segments their own style</source>
        <translation>Segmenten eigenen Stil geben</translation>
    </message>
    <message>
        <source>Follow the stroke&apos;s style</source>
        <translation>Dem Stil des Strichs folgen</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>Nicht für die ganze Auswahl möglich: %1</translation>
    </message>
    <message>
        <source>The style of the wash is seen in place of this one.</source>
        <translation>Statt dieses Stils ist der der Lavierung zu sehen.</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchGrid</name>
    <message>
        <source>Add swatch</source>
        <translation>Farbfeld hinzufügen</translation>
    </message>
    <message>
        <source>Move swatch</source>
        <translation>Farbfeld verschieben</translation>
    </message>
    <message>
        <source>Rename swatch</source>
        <translation>Farbfeld umbenennen</translation>
    </message>
    <message>
        <source>Remove swatch</source>
        <translation>Farbfeld entfernen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Link swatch</source>
        <translation>Farbfeld verknüpfen</translation>
    </message>
    <message>
        <source>Unlink swatch</source>
        <translation>Verknüpfung des Farbfelds lösen</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>verknüpft</translation>
    </message>
    <message>
        <source>Change the Colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>Linked to What Is Painted with It</source>
        <translation>Mit dem damit Gemalten verknüpft</translation>
    </message>
    <message>
        <source>Select What Has This Colour</source>
        <translation>Auswählen, was diese Farbe hat</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchesSection</name>
    <message>
        <source>Swatches</source>
        <translation>Farbfelder</translation>
    </message>
    <message>
        <source>Add swatch</source>
        <translation>Farbfeld hinzufügen</translation>
    </message>
    <message>
        <source>Keeps the current colour with the painting.</source>
        <translation>Behält die aktuelle Farbe beim Bild.</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>GIMP palettes in and out</source>
        <translation>GIMP-Paletten importieren und exportieren</translation>
    </message>
    <message>
        <source>Colours kept with the painting. Click: take it. Drag to move; Delete removes.</source>
        <translation>Farben, die beim Bild bleiben. Klick: übernehmen. Ziehen verschiebt; Entf entfernt.</translation>
    </message>
    <message>
        <source>None yet: + keeps the current colour.</source>
        <translation>Noch keine: + behält die aktuelle Farbe.</translation>
    </message>
    <message>
        <source>GIMP palettes</source>
        <translation>GIMP-Paletten</translation>
    </message>
    <message>
        <source>Import palette</source>
        <translation>Palette importieren</translation>
    </message>
    <message>
        <source>Export palette</source>
        <translation>Palette exportieren</translation>
    </message>
    <message>
        <source>Remove all swatches</source>
        <translation>Alle Farbfelder entfernen</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Map Colours to Swatches</source>
        <translation>Farben auf Farbfelder abbilden</translation>
    </message>
    <message>
        <source>Gives what is selected, or else all of the painting, the swatch that looks nearest</source>
        <translation>Gibt dem Ausgewählten, sonst dem ganzen Bild, das Farbfeld, das am ähnlichsten aussieht</translation>
    </message>
    <message>
        <source>Import Palette…</source>
        <translation>Palette importieren …</translation>
    </message>
    <message>
        <source>Export Palette…</source>
        <translation>Palette exportieren …</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Alle entfernen</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message>
        <source>The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg or pfm numbered pictures, such as frame%04d.png.</source>
        <translation>Die Endung bestimmt das Format: webm oder mp4 ist ein Video, webp eine Animation, und png, tiff, exr, jpg oder pfm sind nummerierte Bilder, etwa frame%04d.png.</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>How many pictures a second the film has</source>
        <translation>Wie viele Bilder je Sekunde der Film hat</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How long the film is; the painting&apos;s time is stretched over it.</source>
        <translation>Wie lang der Film ist; die Zeit des Bildes wird darauf gestreckt.</translation>
    </message>
    <message>
        <source>Animated WebP: begins anew at its end. Players decide it for videos.</source>
        <translation>WebP-Animation: beginnt am Ende von vorn. Bei Videos entscheidet das Abspielprogramm.</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>Numbered pictures</source>
        <translation>Nummerierte Bilder</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Einzelbilder</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A film of %1 frames is too long. Choose a lower rate or a shorter length.</source>
        <translation>Ein Film von %1 Bildern ist zu lang. Bitte eine niedrigere Bildrate oder eine kürzere Länge wählen.</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Writing the film…</source>
        <translation>Film wird geschrieben …</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1; noch %n Sekunde</numerusform>
            <numerusform>%1; noch %n Sekunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1; noch %n Minute</numerusform>
            <numerusform>%1; noch %n Minuten</numerusform>
        </translation>
    </message>
    <message>
        <source>Longest pause</source>
        <translation>Längste Pause</translation>
    </message>
    <message>
        <source>Pauses in which nothing is painted or spreads are cut to this, in the painting&apos;s time.</source>
        <translation>Pausen, in denen nichts gemalt wird oder verläuft, werden darauf gekürzt, in der Zeit des Bildes.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Endlos wiederholen</translation>
    </message>
    <message>
        <source>Export Timelapse</source>
        <translation>Zeitraffer exportieren</translation>
    </message>
    <message>
        <source>“%1” has no ending of a film or a picture. Choose one of: %2.</source>
        <translation>„%1“ hat keine Endung eines Films oder Bilds. Möglich sind: %2.</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePanel</name>
    <message>
        <source>%1 is out of range: 0.1 to 1000 times is possible.</source>
        <translation>%1 liegt außerhalb des Bereichs: Möglich ist das 0,1- bis 1000-Fache.</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end, when all has dried</source>
        <translation>Der gezeigte Zeitpunkt und das Ende, wenn alles getrocknet ist</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>How fast the painting is played: 0.1 to 1000 times as fast as it was painted</source>
        <translation>Wie schnell das Bild abgespielt wird: 0,1- bis 1000-mal so schnell, wie es gemalt wurde</translation>
    </message>
    <message>
        <source>Show all of the time (0). Ctrl+wheel zooms.</source>
        <translation>Die ganze Zeit zeigen (0). Strg+Rad zoomt.</translation>
    </message>
    <message>
        <source>Show all of the time</source>
        <translation>Die ganze Zeit zeigen</translation>
    </message>
    <message>
        <source>Go to Its &amp;Start</source>
        <translation>Zu seinem &amp;Anfang</translation>
    </message>
    <message>
        <source>Go to When It Is Dr&amp;y</source>
        <translation>Dorthin, wo er &amp;trocken ist</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>&amp;Zeichentempo</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePointer</name>
    <message>
        <source>Stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message>
        <source>Drawn from %1 to %2</source>
        <translation>Gezeichnet von %1 bis %2</translation>
    </message>
    <message>
        <source>Dry at %1</source>
        <translation>Trocken bei %1</translation>
    </message>
    <message>
        <source>Erased in part from %1 on</source>
        <translation>Ab %1 teilweise radiert</translation>
    </message>
    <message>
        <source>Wetted again, dry at %1</source>
        <translation>Wieder angefeuchtet, trocken bei %1</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>A bar for each stroke, from when it was painted until it is dry.</source>
        <translation>Ein Balken für jeden Strich, vom Malen bis zum Trocknen.</translation>
    </message>
</context>
<context>
    <name>suffuse::TransformBar</name>
    <message>
        <source>X</source>
        <extracomment>left edge of the selection</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the selected strokes&apos; curves</source>
        <translation>Linke Kante der Kurven der ausgewählten Striche</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the selected strokes&apos; curves</source>
        <translation>Obere Kante der Kurven der ausgewählten Striche</translation>
    </message>
    <message>
        <source>W</source>
        <extracomment>width</extracomment>
        <translation>B</translation>
    </message>
    <message>
        <source>Width of the selected strokes&apos; curves</source>
        <translation>Breite der Kurven der ausgewählten Striche</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Das Verhältnis von Breite und Höhe erhalten</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Seitenverhältnis erhalten</translation>
    </message>
    <message>
        <source>H</source>
        <extracomment>height</extracomment>
        <translation>H</translation>
    </message>
    <message>
        <source>Height of the selected strokes&apos; curves</source>
        <translation>Höhe der Kurven der ausgewählten Striche</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Rotate the selected strokes by this angle</source>
        <translation>Die ausgewählten Striche um diesen Winkel drehen</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Some of these strokes would become too small, too large or too far away to be painted.</source>
        <translation>Einige dieser Striche würden zu klein, zu groß oder zu weit entfernt, um gemalt zu werden.</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlayLoader</name>
    <message>
        <source>Underlay</source>
        <translation>Vorlage</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlaySection</name>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>A picture to paint over. It shows on the canvas only, never in what is exported.</source>
        <translation>Ein Bild zum Übermalen. Es zeigt sich nur auf der Leinwand, nie im Export.</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Show the underlay</source>
        <translation>Vorlage zeigen</translation>
    </message>
    <message>
        <source>Take the underlay out of the painting</source>
        <translation>Die Vorlage aus dem Gemälde nehmen</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How strongly the underlay shows.</source>
        <translation>Wie stark sich die Vorlage zeigt.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the underlay</source>
        <translation>Linker Rand der Vorlage</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the underlay</source>
        <translation>Oberer Rand der Vorlage</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the underlay</source>
        <translation>Breite der Vorlage</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the underlay</source>
        <translation>Höhe der Vorlage</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>Das Verhältnis von Breite und Höhe beibehalten</translation>
    </message>
    <message>
        <source>Fit to Canvas</source>
        <translation>An Leinwand anpassen</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it goes</source>
        <translation>Mitten auf der Leinwand, so groß wie möglich</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Ersetzen …</translation>
    </message>
    <message>
        <source>Another picture in its place</source>
        <translation>Ein anderes Bild an seiner Stelle</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>Vorlage importieren</translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>From one visible edge of the paint to the other, at its widest, as it is now</source>
        <translation>Von einem sichtbaren Rand der Farbe zum anderen, an der breitesten Stelle, so wie sie jetzt ist</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>All that is selected</source>
        <translation>Alles, was ausgewählt ist</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>The segment under the pointer alone</source>
        <translation>Nur das Segment unter dem Zeiger</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>Breite ändern</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, segment %2</source>
        <translation>%1, Segment %2</translation>
    </message>
</context>
<context>
    <name>suffuse::ShapeTool</name>
    <message>
        <source>Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.</source>
        <translation>Von der Mitte zu einer Ecke ziehen. Umschalt: in 15°-Schritten. Eingabe: wie die letzte.</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.</source>
        <translation>Von Ecke zu Ecke ziehen. Umschalt: gleiche Seiten. Strg: von der Mitte. Eingabe: wie die letzte.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Radius of the corners; half of the shorter side is the most</source>
        <translation>Radius der Ecken; höchstens die Hälfte der kürzeren Seite</translation>
    </message>
    <message>
        <source>How many corners a polygon, or tips a star has</source>
        <translation>Wie viele Ecken ein Vieleck oder Spitzen ein Stern hat</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Radius of the inner corners, as a share of that of the tips</source>
        <translation>Radius der inneren Ecken, als Anteil dessen der Spitzen</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source>How much of each side is round</source>
        <translation>Wie viel von jeder Seite rund ist</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Where the arc begins, clockwise from the right</source>
        <translation>Wo der Bogen beginnt, im Uhrzeigersinn von rechts</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>How far the arc goes round; 360° is the whole ellipse</source>
        <translation>Wie weit der Bogen reicht; 360° ist die ganze Ellipse</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>Kreissektor</translation>
    </message>
    <message>
        <source>An arc is closed through the middle; else by a straight line</source>
        <translation>Ein Bogen wird durch die Mitte geschlossen, sonst durch eine Gerade</translation>
    </message>
</context>
<context>
    <name>suffuse::FillSection</name>
    <message>
        <source>How fast the fill spreads: the spread grows with the root of D times time. 0 keeps its edge crisp at any zoom.</source>
        <translation>Wie schnell sich die Füllung ausbreitet: mit der Wurzel aus D mal Zeit. 0 hält ihren Rand bei jeder Vergrößerung scharf.</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>Dichte ρ</translation>
    </message>
    <message>
        <source>Density ρ deep within the fill. On its outline it is half of that, so that with 1 and a threshold of ½ the paint ends there.</source>
        <translation>Dichte ρ tief in der Füllung. Auf dem Umriss ist sie halb so groß, sodass die Farbe mit 1 und einer Schwelle von ½ dort endet.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>What the stroke encloses was wetted at once, and spreads like its paint</source>
        <translation>Was der Strich umschließt, wurde auf einmal genässt und breitet sich aus wie seine Farbe</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>All that is enclosed</source>
        <translation>Alles Umschlossene</translation>
    </message>
    <message>
        <source>Every other area</source>
        <translation>Jede zweite Fläche</translation>
    </message>
    <message>
        <source>What is inside where the outline overlaps itself (nonzero and even-odd in SVG)</source>
        <translation>Was innen ist, wo der Umriss sich überlappt (nonzero und evenodd in SVG)</translation>
    </message>
    <message>
        <source>Change fill</source>
        <translation>Füllung ändern</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>Füllung entfernen</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für alles Gewählte möglich: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
</context>
<context>
    <name>suffuse::VaryDialog</name>
    <message>
        <source>Vary at Random</source>
        <translation>Zufällig abwandeln</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Abwandeln</translation>
    </message>
    <message>
        <source>D becomes greater by up to this, or smaller by the same factor</source>
        <translation>D wird um bis zu diesem größer, oder um denselben Faktor kleiner</translation>
    </message>
    <message>
        <source>φ becomes greater by up to this, or smaller by the same factor</source>
        <translation>φ wird um bis zu diesem größer, oder um denselben Faktor kleiner</translation>
    </message>
    <message>
        <source>t_max becomes greater by up to this, or smaller by the same factor</source>
        <translation>t_max wird um bis zu diesem größer, oder um denselben Faktor kleiner</translation>
    </message>
    <message>
        <source>So much more grain, or less</source>
        <translation>So viel mehr Körnung, oder weniger</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Colours turn by up to this angle, either way</source>
        <translation>Farben drehen sich um bis zu diesem Winkel, hin oder her</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Colours get lighter or darker by up to this</source>
        <translation>Farben werden um bis zu diesem heller oder dunkler</translation>
    </message>
    <message>
        <source>So much more opaque, or less</source>
        <translation>So viel deckender, oder weniger</translation>
    </message>
    <message>
        <source>Roll Again</source>
        <translation>Neu würfeln</translation>
    </message>
    <message>
        <source>Other random values by the same amounts</source>
        <translation>Andere Zufallswerte im selben Maß</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>Jeder Strich</translation>
    </message>
    <message>
        <source>Each segment</source>
        <translation>Jedes Segment</translation>
    </message>
    <message>
        <source>Along each stroke</source>
        <translation>Entlang jedes Strichs</translation>
    </message>
    <message>
        <source>What gets a random value of its own; along a stroke values drift smoothly</source>
        <translation>Was einen eigenen Zufallswert erhält; entlang eines Strichs wandern die Werte sanft</translation>
    </message>
    <message>
        <source>Of its own</source>
        <translation>Für sich</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Over this length along a stroke values become others</source>
        <translation>Über diese Länge entlang eines Strichs werden die Werte andere</translation>
    </message>
</context>
<context>
    <name>suffuse::WishFields</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>What is painted onto the segments</source>
        <translation>Was auf die Segmente gemalt wird</translation>
    </message>
    <message>
        <source>Towards a value, or from the value that each segment has</source>
        <translation>Auf einen Wert zu, oder ausgehend vom Wert, den jedes Segment hat</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>What a segment has when it got all of it</source>
        <translation>Was ein Segment hat, wenn es alles davon bekommen hat</translation>
    </message>
    <message>
        <source>set to</source>
        <translation>setzen auf</translation>
    </message>
    <message>
        <source>multiply by</source>
        <translation>multiplizieren</translation>
    </message>
    <message>
        <source>add</source>
        <translation>addieren</translation>
    </message>
    <message>
        <source>the current colour</source>
        <translation>die aktuelle Farbe</translation>
    </message>
</context>
<context>
    <name>suffuse::GradientRows</name>
    <message>
        <source>Gradient</source>
        <translation>Farbverlauf</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>The fill&apos;s colour fades from left to right. The Segments tool drags the ends.</source>
        <translation>Die Farbe der Füllung verblasst von links nach rechts. Das Werkzeug Segmente zieht die Enden.</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>Farbverlauf hinzufügen</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>The two colours change places</source>
        <translation>Die beiden Farben tauschen die Plätze</translation>
    </message>
    <message>
        <source>Swap colours of gradient</source>
        <translation>Farben des Farbverlaufs tauschen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The fill has its first colour everywhere</source>
        <translation>Die Füllung hat überall ihre erste Farbe</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>Farbverlauf entfernen</translation>
    </message>
    <message>
        <source>The second colour of the gradient</source>
        <translation>Die zweite Farbe des Farbverlaufs</translation>
    </message>
    <message>
        <source>Change gradient</source>
        <translation>Farbverlauf ändern</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für alles möglich, was ausgewählt ist: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
</context>
<context>
    <name>ColourPicker</name>
    <message>
        <source>Beside the canvas there is no paint to take a colour from, unless paint beyond the canvas is shown.</source>
        <translation>Neben der Leinwand lässt sich keine Farbe aufnehmen, außer wenn Farbe neben der Leinwand gezeigt wird.</translation>
    </message>
</context>
<context>
    <name>GradientHandles</name>
    <message>
        <source>Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.</source>
        <translation>Ein Ende des Farbverlaufs ziehen. Strg: in Schritten von 15°. Ein Klick darauf: Farben gelten ihm.</translation>
    </message>
    <message>
        <source>Move gradient</source>
        <translation>Farbverlauf verschieben</translation>
    </message>
</context>
<context>
    <name>suffuse::PenTool</name>
    <message>
        <source>Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.</source>
        <translation>Klick: Ecke. Ziehen: Kurve, Alt: nur ein Anfasser. Erster Knoten: schließen. Eingabe: Ende. Rücktaste: zurück.</translation>
    </message>
    <message>
        <source>Click or drag to go on with the selected stroke from its end.</source>
        <translation>Klick oder Ziehen setzt den ausgewählten Strich von seinem Ende an fort.</translation>
    </message>
    <message>
        <source>Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.</source>
        <translation>Klick: Ecke, Ziehen: Kurve. Umschalt: Schritte von 15°. Ende eines ausgewählten Strichs: fortsetzen.</translation>
    </message>
    <message>
        <source>Extend outline</source>
        <translation>Umriss fortsetzen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
</context>
<context>
    <name>suffuse::LassoFillTool</name>
    <message>
        <source>Click: straight line. First point, double click or Return: close. Shift: steps of 15°.</source>
        <translation>Klick: gerade Linie. Erster Punkt, Doppelklick oder Eingabe: schließen. Umschalt: Schritte von 15°.</translation>
    </message>
    <message>
        <source>Draw around what is to be filled. Alt at the end, or clicks: straight lines.</source>
        <translation>Umfahren, was gefüllt werden soll. Alt am Ende, oder Klicks: gerade Linien.</translation>
    </message>
    <message>
        <source>Lasso fill</source>
        <translation>Lasso-Füllung</translation>
    </message>
</context>
<context>
    <name>suffuse::BucketTool</name>
    <message>
        <source>Click: fill what the paint around that place bounds, with the brush in hand.</source>
        <translation>Klick: füllt mit dem Pinsel in der Hand, was die Farbe um die Stelle begrenzt.</translation>
    </message>
    <message>
        <source>Over all strokes</source>
        <translation>Über allen Strichen</translation>
    </message>
    <message>
        <source>Under all strokes</source>
        <translation>Unter allen Strichen</translation>
    </message>
    <message>
        <source>Where the fill lies</source>
        <translation>Wo die Füllung liegt</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>By how much colours may differ from that under the pointer</source>
        <translation>Wie sehr Farben von der unter dem Zeiger abweichen dürfen</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>Openings of the bounds that are narrower are closed</source>
        <translation>Schmalere Öffnungen der Grenzen gelten als geschlossen</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Wachsen um</translation>
    </message>
    <message>
        <source>How far the fill reaches under its bounds</source>
        <translation>Wie weit die Füllung unter ihre Grenzen reicht</translation>
    </message>
    <message>
        <source>Only what lies on the canvas is filled.</source>
        <translation>Nur was auf der Leinwand liegt, wird gefüllt.</translation>
    </message>
    <message>
        <source>There is nothing to fill here.</source>
        <translation>Hier ist nichts zu füllen.</translation>
    </message>
    <message>
        <source>Bucket fill</source>
        <translation>Farbeimer</translation>
    </message>
    <message>
        <source>Looking for what the paint bounds there. Esc gives it up.</source>
        <translation>Sucht, was die Farbe dort begrenzt. Esc bricht ab.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile: nothing was filled.</source>
        <translation>Das Gemälde hat sich inzwischen geändert: Es wurde nichts gefüllt.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextEntry</name>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
</context>
<context>
    <name>suffuse::TextTool</name>
    <message>
        <source>Something in this text is locked: unlock it to change the text.</source>
        <translation>Etwas in diesem Text ist gesperrt: Zum Ändern des Textes entsperren.</translation>
    </message>
    <message>
        <source>The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or type on: new letters are those of a font like it.</source>
        <translation>Die Schrift „%1“ ist hier nicht installiert, daher bleiben diese Buchstaben, wie sie sind. Oben eine andere wählen oder weiterschreiben: Neue Buchstaben kommen aus einer ähnlichen Schrift.</translation>
    </message>
    <message>
        <source>Type. Return: a new line. Esc or a click elsewhere: done.</source>
        <translation>Schreiben. Eingabe: neue Zeile. Esc oder ein Klick daneben: fertig.</translation>
    </message>
    <message>
        <source>Click or Return: type a text, or in the text that is there.</source>
        <translation>Klick oder Eingabe: einen Text schreiben, oder in den, der dort steht.</translation>
    </message>
</context>
<context>
    <name>suffuse::TextRow</name>
    <message>
        <source>Font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Font: it is not installed here, and another one stands in</source>
        <translation>Schrift: Sie ist hier nicht installiert, und eine andere vertritt sie</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Leicht</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Semibold</source>
        <translation>Halbfett</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>How strong the letters are</source>
        <translation>Wie kräftig die Buchstaben sind</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>Kursiv</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The em of the font</source>
        <translation>Das Geviert der Schrift</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Room that is added between letters, of the size</source>
        <translation>Raum, der zwischen Buchstaben dazukommt, bezogen auf die Größe</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>From one line to the next, of the size</source>
        <translation>Von einer Zeile zur nächsten, bezogen auf die Größe</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Where lines lie: they begin at the text&apos;s place, are centred on it, or end there</source>
        <translation>Wo Zeilen liegen: Sie beginnen am Ort des Textes, liegen mittig zu ihm oder enden dort</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Lines run from top to bottom, and follow each other from right to left</source>
        <translation>Zeilen laufen von oben nach unten und folgen einander von rechts nach links</translation>
    </message>
    <message>
        <source>On Selected Stroke</source>
        <translation>Auf gewähltem Strich</translation>
    </message>
    <message>
        <source>Set the text along the selected stroke, which it follows from then on</source>
        <translation>Den Text entlang dem gewählten Strich setzen, dem er fortan folgt</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Take the text off its curve</source>
        <translation>Den Text von seiner Kurve nehmen</translation>
    </message>
</context>
<context>
    <name>suffuse::TextValues</name>
    <message>
        <source>Change text</source>
        <translation>Text ändern</translation>
    </message>
</context>
<context>
    <name>suffuse::BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Negativ multiplizieren</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Ineinanderkopieren</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>Abdunkeln</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>Aufhellen</translation>
    </message>
    <message>
        <source>Colour Dodge</source>
        <translation>Farbig abwedeln</translation>
    </message>
    <message>
        <source>Colour Burn</source>
        <translation>Farbig nachbelichten</translation>
    </message>
    <message>
        <source>Hard Light</source>
        <translation>Hartes Licht</translation>
    </message>
    <message>
        <source>Soft Light</source>
        <translation>Weiches Licht</translation>
    </message>
    <message>
        <source>Difference</source>
        <comment>blend mode</comment>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <comment>blend mode</comment>
        <translation>Ausschluss</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>Luminanz</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>Mask Below</source>
        <translation>Unteres maskieren</translation>
    </message>
    <message>
        <source>Erase Below</source>
        <translation>Unteres radieren</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>Auf Unteres begrenzen</translation>
    </message>
    <message>
        <source>The group covers what lies below.</source>
        <translation>Die Gruppe deckt, was darunter liegt.</translation>
    </message>
    <message>
        <source>Darkens, as glazes and shadows do; white changes nothing.</source>
        <translation>Dunkelt ab, wie Lasuren und Schatten; Weiß ändert nichts.</translation>
    </message>
    <message>
        <source>Lightens, as lights do that fall on one place; black changes nothing.</source>
        <translation>Hellt auf, wie Lichter, die auf dieselbe Stelle fallen; Schwarz ändert nichts.</translation>
    </message>
    <message>
        <source>Multiplies where it is dark below, and screens where it is light there.</source>
        <translation>Multipliziert, wo es darunter dunkel ist, und multipliziert negativ, wo es dort hell ist.</translation>
    </message>
    <message>
        <source>Of each channel the darker value stays.</source>
        <translation>Von jedem Kanal bleibt der dunklere Wert.</translation>
    </message>
    <message>
        <source>Of each channel the lighter value stays.</source>
        <translation>Von jedem Kanal bleibt der hellere Wert.</translation>
    </message>
    <message>
        <source>Brightens what lies below, strongly where the group is light.</source>
        <translation>Macht heller, was darunter liegt, und zwar stark, wo die Gruppe hell ist.</translation>
    </message>
    <message>
        <source>Deepens what lies below, strongly where the group is dark.</source>
        <translation>Macht tiefer, was darunter liegt, und zwar stark, wo die Gruppe dunkel ist.</translation>
    </message>
    <message>
        <source>Multiplies where the group is dark, and screens where it is light.</source>
        <translation>Multipliziert, wo die Gruppe dunkel ist, und multipliziert negativ, wo sie hell ist.</translation>
    </message>
    <message>
        <source>Darkens or lightens gently, as a diffuse light does.</source>
        <translation>Dunkelt sanft ab oder hellt sanft auf, wie gestreutes Licht.</translation>
    </message>
    <message>
        <source>How far both are apart; white inverts what lies below.</source>
        <translation>Wie weit beide auseinanderliegen; Weiß kehrt um, was darunter liegt.</translation>
    </message>
    <message>
        <source>As Difference, with less contrast.</source>
        <translation>Wie Differenz, mit weniger Kontrast.</translation>
    </message>
    <message>
        <source>The hue of the group, with saturation and luminosity of what lies below.</source>
        <translation>Der Farbton der Gruppe, mit Sättigung und Luminanz dessen, was darunter liegt.</translation>
    </message>
    <message>
        <source>The saturation of the group, with hue and luminosity of what lies below.</source>
        <translation>Die Sättigung der Gruppe, mit Farbton und Luminanz dessen, was darunter liegt.</translation>
    </message>
    <message>
        <source>Hue and saturation of the group, with the luminosity of what lies below: for tinting.</source>
        <translation>Farbton und Sättigung der Gruppe, mit der Luminanz dessen, was darunter liegt: zum Tönen.</translation>
    </message>
    <message>
        <source>The luminosity of the group, with hue and saturation of what lies below.</source>
        <translation>Die Luminanz der Gruppe, mit Farbton und Sättigung dessen, was darunter liegt.</translation>
    </message>
    <message>
        <source>The sum of both, for glows (plus, linear dodge).</source>
        <translation>Die Summe von beidem, für Leuchten (plus, linear abwedeln).</translation>
    </message>
    <message>
        <source>The group is not seen itself: what lies below stays where the group covers, and goes elsewhere (destination-in).</source>
        <translation>Die Gruppe selbst ist nicht zu sehen: Was darunter liegt, bleibt, wo die Gruppe deckt, und verschwindet sonst (destination-in).</translation>
    </message>
    <message>
        <source>The group is not seen itself: it takes away what lies below where it covers (destination-out).</source>
        <translation>Die Gruppe selbst ist nicht zu sehen: Wo sie deckt, nimmt sie weg, was darunter liegt (destination-out).</translation>
    </message>
    <message>
        <source>The group is seen only where paint lies below it: for shading a shape without leaving it (source-atop).</source>
        <translation>Die Gruppe ist nur zu sehen, wo Farbe unter ihr liegt: um eine Form zu schattieren, ohne sie zu verlassen (source-atop).</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupSection</name>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap in it do not show through each other.</source>
        <translation>Wie stark die Gruppe zu sehen ist. Unter 100 % verblasst sie als Ganzes: Striche, die sich in ihr überlappen, scheinen nicht durcheinander hindurch.</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>Deckkraft der Gruppe ändern</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>Nicht für alles möglich, was ausgewählt ist: Ein Wert läge außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>Modus der Gruppe ändern</translation>
    </message>
    <message>
        <source>Mix by itself</source>
        <translation>Für sich mischen</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>Gruppe für sich mischen</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>Gruppe mit dem Bild darunter mischen</translation>
    </message>
    <message>
        <source>How the group&apos;s picture is put on what lies below. Any mode but Normal has its strokes mix by themselves first.</source>
        <translation>Wie das Bild der Gruppe auf das kommt, was darunter liegt. Bei jedem Modus außer Normal mischen sich ihre Striche zuerst für sich.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>the mode that is chosen, and what it does</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The group&apos;s strokes mix among themselves, and their picture is put on what lies below. Otherwise they mix with what lies below as if there were no group.</source>
        <translation>Die Striche der Gruppe mischen sich untereinander, und ihr Bild kommt auf das, was darunter liegt. Sonst mischen sie sich mit dem, was darunter liegt, als gäbe es keine Gruppe.</translation>
    </message>
    <message>
        <source>Clip to below</source>
        <translation>Auf Unteres begrenzen</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>Lavierung</translation>
    </message>
    <message>
        <source>The group is seen only where the next thing below it in the same group is: for shading a shape without leaving it.</source>
        <translation>Die Gruppe ist nur dort zu sehen, wo in derselben Gruppe das Nächste unter ihr ist: um eine Form zu schattieren, ohne über sie hinauszumalen.</translation>
    </message>
    <message>
        <source>The group is not seen itself; what else is in the same group is seen only where it has paint.</source>
        <translation>Die Gruppe selbst ist nicht zu sehen; was sonst in derselben Gruppe ist, ist nur dort zu sehen, wo sie Farbe hat.</translation>
    </message>
    <message>
        <source>All strokes of the group are one, laid wet into wet: their densities add up, with one style and one mixing. Filled strokes, hidden ones and those of a mask within it stay by themselves.</source>
        <translation>Alle Striche der Gruppe sind einer, nass in nass aufgetragen: Ihre Dichten summieren sich, mit einem Stil und einer Mischung. Gefüllte und ausgeblendete Striche und die einer Maske darin bleiben für sich.</translation>
    </message>
    <message>
        <source>There is nothing below it to clip to.</source>
        <translation>Unter ihr ist nichts, worauf sie begrenzt werden könnte.</translation>
    </message>
    <message>
        <source>There is nothing beside it to mask.</source>
        <translation>Neben ihr ist nichts, was sie maskieren könnte.</translation>
    </message>
    <message>
        <source>It is in a wash already.</source>
        <translation>Sie ist schon in einer Lavierung.</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>A colour that marks the group for you, in lists. It is not seen in the picture.</source>
        <translation>Eine Farbe, die die Gruppe in Listen für Sie markiert. Im Bild ist sie nicht zu sehen.</translation>
    </message>
    <message>
        <source>Mark group</source>
        <translation>Gruppe markieren</translation>
    </message>
    <message>
        <source>The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a mask.</source>
        <translation>Die Gruppe mischt sich in jedem Fall für sich: durch ihre Deckkraft oder ihren Modus, oder weil sie begrenzt oder eine Maske ist.</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>The group is seen here, and left out of pictures and films that are exported: for sketches and pictures to paint over.</source>
        <translation>Die Gruppe ist hier zu sehen, aber nicht in Bildern und Filmen, die exportiert werden: für Skizzen und Bilder zum Abmalen.</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupTag</name>
    <message>
        <source>None</source>
        <comment>mark of a group</comment>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Red</source>
        <comment>mark of a group</comment>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Orange</source>
        <comment>mark of a group</comment>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <comment>mark of a group</comment>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Green</source>
        <comment>mark of a group</comment>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <comment>mark of a group</comment>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Violet</source>
        <comment>mark of a group</comment>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Brown</source>
        <comment>mark of a group</comment>
        <translation>Braun</translation>
    </message>
    <message>
        <source>Grey</source>
        <comment>mark of a group</comment>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>%1: the linked picture is missing or has changed. Put it back, or link it anew in the Inspector.</source>
        <translation>%1: Das verknüpfte Bild fehlt oder wurde geändert. Bitte an seinen Platz zurücklegen oder im Inspektor neu verknüpfen.</translation>
    </message>
    <message>
        <source>the image of a picture is missing</source>
        <translation>das Bild fehlt</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>LayeredFile</name>
    <message>
        <source>%1: Photoshop files have at most 2 GB. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: Photoshop-Dateien haben höchstens 2 GB. Wählen Sie eine kleinere Größe oder OpenRaster.</translation>
    </message>
    <message>
        <source>%1: Photoshop files have at most %2 pixels a side. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: Photoshop-Dateien haben höchstens %2 Pixel je Seite. Wählen Sie eine kleinere Größe oder OpenRaster.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>The file could not be packed.</source>
        <translation>Die Datei konnte nicht gepackt werden.</translation>
    </message>
</context>
<context>
    <name>ImageLayer</name>
    <message>
        <source>%1: the pictures of a painting may have %2 million pixels together, and this one would be too many. Scale it down, or remove another one.</source>
        <translation>%1: Die Bilder eines Gemäldes dürfen zusammen %2 Millionen Pixel haben, mit diesem wären es zu viele. Bitte verkleinern oder ein anderes entfernen.</translation>
    </message>
    <message>
        <source>Import picture</source>
        <translation>Bild importieren</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The picture of the clipboard cannot be read.</source>
        <translation>Das Bild der Zwischenablage kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Paste picture</source>
        <translation>Bild einfügen</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Underlay to layer</source>
        <translation>Vorlage zur Ebene machen</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Bild verknüpfen</translation>
    </message>
    <message>
        <source>Embed picture</source>
        <translation>Bild einbetten</translation>
    </message>
    <message>
        <source>Reset proportions</source>
        <translation>Proportionen zurücksetzen</translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Linked to a file</source>
        <translation>Mit einer Datei verknüpft</translation>
    </message>
    <message>
        <source>The painting names the picture&apos;s file, and does not hold the picture itself. Otherwise the picture is in the painting, whatever becomes of the file.</source>
        <translation>Das Gemälde nennt die Datei des Bildes und enthält es nicht selbst. Sonst ist das Bild im Gemälde, was auch immer aus der Datei wird.</translation>
    </message>
    <message>
        <source>Relink…</source>
        <translation>Neu verknüpfen …</translation>
    </message>
    <message>
        <source>Another file, or the same one where it lies now, in the picture&apos;s place</source>
        <translation>Eine andere Datei, oder dieselbe an ihrem jetzigen Ort, an Stelle des Bildes</translation>
    </message>
    <message>
        <source>Reset Proportions</source>
        <translation>Proportionen zurücksetzen</translation>
    </message>
    <message>
        <source>As high and wide as its pixels ask for: its top left corner, its direction and its width stay.</source>
        <translation>So hoch und breit, wie seine Pixel es verlangen: Die linke obere Ecke, die Richtung und die Breite bleiben.</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>Bild verknüpfen</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is missing or has changed, and is not seen.</source>
        <translation>%1 fehlt oder wurde geändert und ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>A picture is missing, and is not seen.</source>
        <translation>Ein Bild fehlt und ist nicht zu sehen.</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>unterbrochen; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the sheet is too large for a picture with a pixel a unit</source>
        <translation>das Blatt ist zu groß für ein Bild mit einem Pixel je Einheit</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG kennt keine Gruppen, die löschen, was darunter liegt: %n Gruppe wurde gewöhnlich.</numerusform>
            <numerusform>SVG kennt keine Gruppen, die löschen, was darunter liegt: %n Gruppen wurden gewöhnlich.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>%n Strich fehlt, weil nichts von ihm genug deckt, um einen Pfad zu haben.</numerusform>
            <numerusform>%n Striche fehlen, weil nichts von ihnen genug deckt, um einen Pfad zu haben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The drawing differs from the picture by at most %1 of 255, by %2 on average.</source>
        <translation>Die Zeichnung weicht vom Bild um höchstens %1 von 255 ab, im Mittel um %2.</translation>
    </message>
    <message>
        <source>%1: would have %2 MB once it is unpacked, and could not be opened again. Choose fewer bands, or the ending .svg.</source>
        <translation>%1: hätte entpackt %2 MB und ließe sich nicht mehr öffnen. Bitte weniger Bänder oder die Endung .svg wählen.</translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF kennt keine Gruppen, die löschen, was darunter liegt, oder dazuzählen: %n Gruppe wurde gewöhnlich.</numerusform>
            <numerusform>PDF kennt keine Gruppen, die löschen, was darunter liegt, oder dazuzählen: %n Gruppen wurden gewöhnlich.</numerusform>
        </translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingDialog</name>
    <message>
        <source>One path for each stroke, where it is covered by half: for plotters, cutters, logos.</source>
        <translation>Ein Pfad je Strich, wo er zur Hälfte deckt: für Plotter, Schneider, Logos.</translation>
    </message>
    <message>
        <source>Contours within each other, as opaque as the paint. They look like the painting at any zoom.</source>
        <translation>Höhenlinien ineinander, so deckend wie die Farbe. Sie sehen bei jeder Vergrößerung wie das Gemälde aus.</translation>
    </message>
    <message>
        <source>The exact picture, a pixel a unit, and over it the outlines without paint, to select and name strokes by.</source>
        <translation>Das genaue Bild, ein Pixel je Einheit, darüber die Umrisse ohne Farbe, um Striche auszuwählen und zu benennen.</translation>
    </message>
    <message>
        <source>Export Drawing</source>
        <translation>Zeichnung exportieren</translation>
    </message>
    <message>
        <source>The ending chooses the format: svg, svgz, which is packed, or pdf.</source>
        <translation>Die Endung bestimmt das Format: svg, svgz, das gepackt ist, oder pdf.</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>Bänder</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Picture and outlines</source>
        <translation>Bild und Umrisse</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What of the painting becomes paths</source>
        <translation>Was vom Gemälde zu Pfaden wird</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>How many bands full opacity is drawn in. More of them are smoother, and make a larger file.</source>
        <translation>In wie vielen Bändern volle Deckkraft gezeichnet wird. Mehr sind glatter und machen die Datei größer.</translation>
    </message>
    <message>
        <source>Of red, green and blue, over the sheet, with a pixel a unit</source>
        <translation>Von Rot, Grün und Blau auf dem ganzen Blatt, ein Pixel je Einheit</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Comparing with the picture…</source>
        <translation>Wird mit dem Bild verglichen …</translation>
    </message>
    <message>
        <source>It is exported as soon as it is compared with the picture.</source>
        <translation>Exportiert wird, sobald mit dem Bild verglichen ist.</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>Zeichnungen</translation>
    </message>
    <message>
        <source>“%1” has no ending of a drawing. Choose one of: %2.</source>
        <translation>„%1“ hat keine Endung einer Zeichnung. Möglich sind: %2.</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>So groß wie das Blatt</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where that is not said, has 96 units an inch.</source>
        <translation>In einer PDF-Datei: Das Blatt passt in die Mitte der Seite. Für sich ist es so groß wie auf Papier oder hat, wo das nicht gesagt ist, 96 Einheiten je Zoll.</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingJob</name>
    <message>
        <source>The drawing does not fit into memory.</source>
        <translation>Die Zeichnung passt nicht in den Speicher.</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln Zeile</numerusform>
            <numerusform>%Ln Zeilen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ColourProfile</name>
    <message>
        <source>it is no ICC profile of RGB, grey or CMYK</source>
        <translation>es ist kein ICC-Profil für RGB, Grau oder CMYK</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is too large</source>
        <translation>%1: nicht lesbar oder zu groß</translation>
    </message>
</context>
<context>
    <name>suffuse::Proofing</name>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Profil der Farbprüfung</translation>
    </message>
    <message>
        <source>Colours not converted</source>
        <translation>Farben nicht umgerechnet</translation>
    </message>
    <message>
        <source>Proof: %1</source>
        <translation>Prüfung: %1</translation>
    </message>
</context>
<context>
    <name>ChooseProfile</name>
    <message>
        <source>Colour profiles</source>
        <translation>Farbprofile</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPage</name>
    <message>
        <source>That of the system</source>
        <translation>Das des Systems</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>Keines (sRGB)</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>Screen profile</source>
        <translation>Bildschirmprofil</translation>
    </message>
    <message>
        <source>What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were meant.</source>
        <translation>Was der Bildschirm aus seinen Zahlen macht. Die Leinwand wird darauf umgerechnet, sodass Farben aussehen wie gemeint.</translation>
    </message>
    <message>
        <source>Screen profile file</source>
        <translation>Profildatei des Bildschirms</translation>
    </message>
    <message>
        <source>Chooses the ICC profile that was measured for this screen</source>
        <translation>Wählt das ICC-Profil, das für diesen Bildschirm gemessen wurde</translation>
    </message>
    <message>
        <source>Soft proof</source>
        <translation>Farbprüfung</translation>
    </message>
    <message>
        <source>Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left there.</source>
        <translation>Wählt das ICC-Profil einer Druckmaschine oder eines Druckers. Ansicht ▸ Farbprüfung zeigt, welche Farben dort bleiben.</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perzeptiv</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Relativ farbmetrisch</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Absolut farbmetrisch</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Umrechnung</translation>
    </message>
    <message>
        <source>What becomes of colours that the device of the soft proof does not have</source>
        <translation>Was aus Farben wird, die das geprüfte Gerät nicht hat</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>Schwarzpunkt anpassen</translation>
    </message>
    <message>
        <source>The darkest colour becomes the darkest one that the device has</source>
        <translation>Die dunkelste Farbe wird die dunkelste, die das Gerät hat</translation>
    </message>
    <message>
        <source>Profile of the Screen</source>
        <translation>Profil des Bildschirms</translation>
    </message>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>Profil der Farbprüfung</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
</context>
<context>
    <name>suffuse::ProfileBox</name>
    <message>
        <source>The painting&apos;s profile</source>
        <translation>Das Profil des Bildes</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei …</translation>
    </message>
    <message>
        <source>%1: the profile is too large to be kept in a painting. Choose a smaller one.</source>
        <translation>%1: Das Profil ist zu groß, um im Bild behalten zu werden. Ein kleineres wählen.</translation>
    </message>
    <message>
        <source>%1: %2. Choose a profile of RGB colours.</source>
        <translation>%1: %2. Ein Profil für RGB-Farben wählen.</translation>
    </message>
    <message>
        <source>Profile of the Colours</source>
        <translation>Profil der Farben</translation>
    </message>
</context>
<context>
    <name>suffuse::FitJob</name>
    <message>
        <source>%1: there is not enough memory to fit it.</source>
        <translation>%1: Der Speicher reicht nicht, um Striche daraus zu machen.</translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message>
        <source>Ground</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Picture to strokes</source>
        <translation>Bild in Striche umwandeln</translation>
    </message>
    <message>
        <source>The picture was painted quickly, just before the moment that you look at. All that you painted stays as it is.</source>
        <translation>Das Bild wurde schnell gemalt, kurz vor dem Augenblick, den Sie ansehen. Alles, was Sie gemalt haben, bleibt, wie es ist.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>%Ln Strich kam dazu, und ein Grund darunter.</numerusform>
            <numerusform>%Ln Striche kamen dazu, und ein Grund darunter.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitView</name>
    <message>
        <source>Picture made of strokes</source>
        <translation>Bild aus Strichen</translation>
    </message>
    <message>
        <source>What the strokes look like. While a mouse button is held on it, the original is seen.</source>
        <translation>So sehen die Striche aus. Solange darauf eine Maustaste gedrückt ist, ist das Original zu sehen.</translation>
    </message>
    <message>
        <source>Here the picture grows, stroke by stroke.</source>
        <translation>Hier wächst das Bild, Strich für Strich.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitRows</name>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>At most so many. More of them go on with those that are there; fewer begin anew.</source>
        <translation>Höchstens so viele. Mehr setzen auf den vorhandenen auf, weniger beginnen von vorn.</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Sorgfalt</translation>
    </message>
    <message>
        <source>How much is done for each stroke. Better goes on with what is there.</source>
        <translation>Wie viel für jeden Strich getan wird. Mehr setzt auf dem Vorhandenen auf.</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Am besten</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Of all strokes. Another one begins anew.</source>
        <translation>Aller Striche. Ein anderer beginnt von vorn.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Each stroke its own, or a few paints, which become linked swatches</source>
        <translation>Jedem Strich seine eigene, oder wenige, die zu verknüpften Farbfeldern werden</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Few paints</source>
        <translation>Wenige</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Anzahl der Farben</translation>
    </message>
    <message>
        <source>So many colours in all</source>
        <translation>So viele Farben insgesamt</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Widths of strokes, and the roll of the dice</source>
        <translation>Breiten der Striche und der Zufall</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>Kleinste Breite</translation>
    </message>
    <message>
        <source>No stroke is narrower; 0: as narrow as it likes</source>
        <translation>Kein Strich ist schmaler; 0: beliebig schmal</translation>
    </message>
    <message>
        <source>Greatest width</source>
        <translation>Größte Breite</translation>
    </message>
    <message>
        <source>No stroke is wider; 0: as wide as it likes</source>
        <translation>Kein Strich ist breiter; 0: beliebig breit</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number gives other strokes, equally good ones</source>
        <translation>Eine andere Zahl ergibt andere, ebenso gute Striche</translation>
    </message>
    <message>
        <source>The greatest width is below the least one.</source>
        <translation>Die größte Breite liegt unter der kleinsten.</translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message>
        <source>far: %1 dB</source>
        <translation>fern: %1 dB</translation>
    </message>
    <message>
        <source>roughly: %1 dB</source>
        <translation>ungefähr: %1 dB</translation>
    </message>
    <message>
        <source>near: %1 dB</source>
        <translation>nah: %1 dB</translation>
    </message>
    <message>
        <source>very near: %1 dB</source>
        <translation>sehr nah: %1 dB</translation>
    </message>
    <message>
        <source>Picture to Strokes</source>
        <translation>Bild in Striche umwandeln</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>Wie weit es ist</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Shows the picture itself: while held, or click to switch back and forth.</source>
        <translation>Zeigt das Bild selbst: solange gedrückt, oder per Klick hin und her.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Which picture becomes strokes</source>
        <translation>Welches Bild zu Strichen wird</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keines</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Puts the strokes so far into the painting, as a layer</source>
        <translation>Fügt die bisherigen Striche als Ebene in das Gemälde ein</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops the work, or goes on with it</source>
        <translation>Hält die Arbeit an oder setzt sie fort</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>Das Bild wird gelesen …</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>off by %1 of 255</source>
        <translation>Abweichung %1 von 255</translation>
    </message>
    <message>
        <source>Fewer Strokes</source>
        <translation>Weniger Striche</translation>
    </message>
    <message>
        <source>What the strokes are to look like: as those that are there do, or as a picture of the whole sheet</source>
        <translation>Wie die Striche aussehen sollen: wie die vorhandenen oder wie ein Bild des ganzen Blattes</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>Wie sie aussehen</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>Puts the strokes so far in place of the selected ones</source>
        <translation>Setzt die bisherigen Striche an die Stelle der ausgewählten</translation>
    </message>
    <message>
        <source>Give up the strokes so far?</source>
        <translation>Die bisherigen Striche aufgeben?</translation>
    </message>
    <message>
        <source>Replace puts them in place of the selected ones.</source>
        <translation>Ersetzen setzt sie an die Stelle der ausgewählten.</translation>
    </message>
    <message>
        <source>Insert puts them into the painting.</source>
        <translation>Einfügen bringt sie ins Bild.</translation>
    </message>
    <message>
        <source>&amp;Give Up</source>
        <translation>&amp;Aufgeben</translation>
    </message>
</context>
<context>
    <name>fitting</name>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>%1: is black all over, so nothing counts; paint white what is to be fitted</source>
        <translation>%1: ist überall schwarz, also zählt nichts; bitte weiß malen, was angepasst werden soll</translation>
    </message>
    <message>
        <source>its canvas has %1 × %2 units, and the picture %3 × %4 pixels; go on with a painting that was fitted to this picture</source>
        <translation>seine Leinwand hat %1 × %2 Einheiten, das Bild %3 × %4 Pixel; bitte mit einem Bild weitermachen, das an dieses angepasst wurde</translation>
    </message>
    <message>
        <source>stroke %1: %2; a fit goes on with what a fit made</source>
        <translation>Strich %1: %2; nur was angepasst wurde, lässt sich weiter anpassen</translation>
    </message>
</context>
<context>
    <name>curves</name>
    <message>
        <source>its picture has %1 × %2 pixels; image_width and image_height must be 1 at least</source>
        <translation>das Bild hat %1 × %2 Pixel; image_width und image_height müssen mindestens 1 sein</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to solve</source>
        <translation>enthält keine Kurven; es gibt nichts zu lösen</translation>
    </message>
</context>
<context>
    <name>refit</name>
    <message>
        <source>none of the strokes is visible and unlocked; choose others</source>
        <translation>keiner der Striche ist sichtbar und nicht gesperrt; wählen Sie andere</translation>
    </message>
    <message>
        <source>the strokes lie beside the sheet, where nothing is seen of them</source>
        <translation>die Striche liegen neben dem Blatt, wo nichts von ihnen zu sehen ist</translation>
    </message>
    <message>
        <source>the strokes of group “%1” mix in their own way; choose all of them that are visible, or none of them</source>
        <translation>die Striche der Gruppe „%1“ mischen sich auf eigene Weise; wählen Sie alle, die sichtbar sind, oder keinen davon</translation>
    </message>
    <message>
        <source>group “%1” is a wash, whose strokes are one; make it a group like others first</source>
        <translation>die Gruppe „%1“ ist eine Lavierung, deren Striche eins sind; machen Sie zuerst eine gewöhnliche Gruppe daraus</translation>
    </message>
    <message>
        <source>%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape of the sheet</source>
        <translation>%1: hat die Form %2 × %3 und das Blatt %4 × %5; schneiden Sie es auf die Form des Blattes zu</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>the strokes are in a group that is put on the others as one picture, so no picture of the whole says how they should look; make it a group like others first</source>
        <translation>die Striche sind in einer Gruppe, die als ein Bild auf die anderen gelegt wird, daher sagt kein Bild des Ganzen, wie sie aussehen sollen; machen Sie zuerst eine gewöhnliche Gruppe daraus</translation>
    </message>
    <message>
        <source>other strokes hide the chosen ones wholly; choose others, or hide what lies above</source>
        <translation>andere Striche verdecken die gewählten ganz; wählen Sie andere oder blenden Sie aus, was darüber liegt</translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message>
        <source>There the picture is off by %1 of 255 (root mean square), %2 at most.</source>
        <translation>Dort weicht das Bild um %1 von 255 ab (quadratisches Mittel), um höchstens %2.</translation>
    </message>
    <message>
        <source>Fewer strokes</source>
        <translation>Weniger Striche</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>anstelle von %Ln.</numerusform>
            <numerusform>anstelle von %Ln.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%Ln Strich, der dazwischen lag, liegt jetzt darunter.</numerusform>
            <numerusform>%Ln Striche, die dazwischen lagen, liegen jetzt darunter.</numerusform>
        </translation>
    </message>
    <message>
        <source>That is farther than before, when it was off by %1; Undo brings the former strokes back.</source>
        <translation>Das ist weiter als zuvor, als es %1 waren; Rückgängig bringt die früheren Striche zurück.</translation>
    </message>
</context>
<context>
    <name>Tiles</name>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start again to go on.</source>
        <translation>%1 Was ein anderes Backend zeichnet, hat andere Bits und wird nicht beigemischt. Starten Sie noch einmal, um fortzufahren.</translation>
    </message>
    <message>
        <source>there is not enough memory for the sheets that are drawn at once</source>
        <translation>für die Bögen, die auf einmal gezeichnet werden, reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>a tile cannot be encoded: %1</source>
        <translation>eine Kachel lässt sich nicht kodieren: %1</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2)</source>
        <translation>%1: lässt sich nicht lesen (%2)</translation>
    </message>
    <message>
        <source>%1: what is there is of another picture, or of another build or backend. Remove it, or choose another name.</source>
        <translation>%1: Was hier liegt, gehört zu einem anderen Bild oder ist von einem anderen Bau oder Backend. Entfernen Sie es oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: lässt sich nicht schreiben (%2). Wählen Sie einen anderen Ordner oder ändern Sie seine Rechte.</translation>
    </message>
    <message>
        <source>%1: another program is drawing the same picture. Wait until it has finished, or choose another name.</source>
        <translation>%1: Ein anderes Programm zeichnet gerade dasselbe Bild. Warten Sie, bis es fertig ist, oder wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>suffuse::ManualWindow</name>
    <message>
        <source>Suffuse Manual</source>
        <translation>Handbuch zu Suffuse</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
</context>
<context>
    <name>suffuse::Lesson</name>
    <message>
        <source>Paint, and change your mind</source>
        <translation>Malen und es sich anders überlegen</translation>
    </message>
    <message>
        <source>Let paint spread</source>
        <translation>Farbe verlaufen lassen</translation>
    </message>
    <message>
        <source>Work with layers</source>
        <translation>Mit Ebenen arbeiten</translation>
    </message>
    <message>
        <source>Done. All of this can be changed at any time.</source>
        <translation>Fertig. All das lässt sich jederzeit wieder ändern.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke on the sheet, however you like.</source>
        <translation>Drücken Sie B und ziehen Sie auf dem Blatt einen Strich, wie Sie mögen.</translation>
    </message>
    <message>
        <source>Press V for the Select tool, and click the paint of your stroke.</source>
        <translation>Drücken Sie V für das Auswahlwerkzeug und klicken Sie auf die Farbe Ihres Strichs.</translation>
    </message>
    <message>
        <source>Choose another colour in the Colour dock. It is now about what is selected.</source>
        <translation>Wählen Sie im Andockfenster Farbe eine andere Farbe. Dort geht es jetzt um das Ausgewählte.</translation>
    </message>
    <message>
        <source>Take it back with Ctrl+Z.</source>
        <translation>Nehmen Sie das mit Strg+Z zurück.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. Watch it spread after you let go.</source>
        <translation>Drücken Sie B und ziehen Sie einen Strich. Sehen Sie zu, wie er nach dem Loslassen verläuft.</translation>
    </message>
    <message>
        <source>Press D: this goes to the moment when everything is dry.</source>
        <translation>Drücken Sie D: Das springt zu dem Moment, in dem alles trocken ist.</translation>
    </message>
    <message>
        <source>In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far.</source>
        <translation>Ziehen Sie im Inspektor den Regler Diffusion D. Die trockene Farbe verläuft weiter oder weniger weit.</translation>
    </message>
    <message>
        <source>Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it.</source>
        <translation>Wählen Sie Ebene ▸ Neue Ebene oder drücken Sie Strg+Umschalt+N. Was Sie als Nächstes malen, kommt hinein.</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. The layer comes into the list with it.</source>
        <translation>Drücken Sie B und ziehen Sie einen Strich. Mit ihm kommt die Ebene in die Liste.</translation>
    </message>
    <message>
        <source>In the row of the layer, drag its opacity to the left, or click its mode and choose another one.</source>
        <translation>Ziehen Sie in der Zeile der Ebene die Deckkraft nach links, oder klicken Sie auf den Modus und wählen Sie einen anderen.</translation>
    </message>
</context>
<context>
    <name>suffuse::LessonCard</name>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – Schritt %2 von %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>Lektion verlassen</translation>
    </message>
</context>
<context>
    <name>suffuse::Sheets</name>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 in</source>
        <translation>%1 × %2 in</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen für Blätter</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>Skizze</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>US Letter</translation>
    </message>
    <message>
        <source>Legal</source>
        <translation>US Legal</translation>
    </message>
    <message>
        <source>Tabloid</source>
        <translation>US Tabloid</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>Postkarte</translation>
    </message>
    <message>
        <source>Watercolour sheet</source>
        <translation>Aquarellblatt</translation>
    </message>
    <message>
        <source>Rice paper</source>
        <translation>Reispapier</translation>
    </message>
    <message>
        <source>Toned paper</source>
        <translation>Getöntes Papier</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Nacht</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
</context>
<context>
    <name>suffuse::WelcomeDialog</name>
    <message>
        <source>Welcome to Suffuse</source>
        <translation>Willkommen bei Suffuse</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>Neues Bild</translation>
    </message>
    <message>
        <source>Other Size…</source>
        <translation>Andere Größe …</translation>
    </message>
    <message>
        <source>Open a painting</source>
        <translation>Bild öffnen</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>Drei kurze Lektionen</translation>
    </message>
    <message>
        <source>Show this at the start</source>
        <translation>Beim Start zeigen</translation>
    </message>
    <message>
        <source>Sheets by their size. Return begins a painting on one.</source>
        <translation>Blätter nach ihrer Größe. Die Eingabetaste beginnt ein Bild auf einem.</translation>
    </message>
    <message>
        <source>Recent paintings and samples. Return opens one.</source>
        <translation>Zuletzt benutzte Bilder und Beispiele. Die Eingabetaste öffnet eines.</translation>
    </message>
</context>
<context>
    <name>suffuse::Workspaces</name>
    <message>
        <source>Save Workspace</source>
        <translation>Arbeitsbereich speichern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>There is a workspace “%1” already.</source>
        <translation>Es gibt schon einen Arbeitsbereich „%1“.</translation>
    </message>
    <message>
        <source>It would be replaced by how the window is arranged now.</source>
        <translation>Er würde dadurch ersetzt, wie das Fenster jetzt angeordnet ist.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The workspace “%1” was saved: View ▸ Workspaces.</source>
        <translation>Der Arbeitsbereich „%1“ wurde gespeichert: Ansicht ▸ Arbeitsbereiche.</translation>
    </message>
    <message>
        <source>The workspace “%1” is damaged. Save it anew.</source>
        <translation>Der Arbeitsbereich „%1“ ist beschädigt. Speichern Sie ihn neu.</translation>
    </message>
    <message>
        <source>&amp;Delete Workspace</source>
        <translation>Arbeitsbereich &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the workspace “%1”?</source>
        <translation>Arbeitsbereich „%1“ löschen?</translation>
    </message>
    <message>
        <source>The window stays arranged as it is.</source>
        <translation>Das Fenster bleibt angeordnet, wie es ist.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferencePanel</name>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Choose a picture to look at while painting</source>
        <translation>Ein Bild wählen, das man beim Malen ansieht</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show all of the picture</source>
        <translation>Das ganze Bild zeigen</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>A pixel of the picture is one of the screen</source>
        <translation>Ein Pixel des Bilds ist eines des Bildschirms</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Show no picture here; its file stays</source>
        <translation>Hier kein Bild zeigen; die Datei bleibt</translation>
    </message>
    <message>
        <source>Open Reference Picture</source>
        <translation>Vorlage öffnen</translation>
    </message>
    <message>
        <source>Actual pixels</source>
        <translation>Tatsächliche Pixel</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferenceView</name>
    <message>
        <source>Reference picture</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Arrow keys move a cross, and Return picks the colour there.</source>
        <translation>Pfeiltasten bewegen ein Kreuz, Eingabe nimmt die Farbe dort auf.</translation>
    </message>
    <message>
        <source>Drop a picture here to look at it while you paint, and to take colours from it.</source>
        <translation>Ziehen Sie ein Bild hierher, um es beim Malen anzusehen und Farben daraus aufzunehmen.</translation>
    </message>
</context>
<context>
    <name>suffuse::ViewWindow</name>
    <message>
        <source>View of the painting</source>
        <translation>Ansicht des Gemäldes</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>%1 · view at %2 %</source>
        <translation>%1 · Ansicht mit %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: install bubblewrap, and they have no network and can write nowhere else.</source>
        <translation>Programme sind in Zeit, Speicher und dem, was sie schreiben, begrenzt, aber nicht abgeschottet: Installieren Sie bubblewrap, dann haben sie kein Netz und können nirgends sonst schreiben.</translation>
    </message>
    <message>
        <source>Programs are confined by bubblewrap: they have no network, unless they say that they need it, and can write in a temporary folder only.</source>
        <translation>Programme sind durch bubblewrap abgeschottet: Sie haben kein Netz, es sei denn, sie sagen, dass sie es brauchen, und können nur in einem temporären Ordner schreiben.</translation>
    </message>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: bubblewrap is installed, and does not work here (%1).</source>
        <translation>Programme sind in Zeit, Speicher und dem, was sie schreiben, begrenzt, aber nicht abgeschottet: bubblewrap ist installiert, geht hier aber nicht (%1).</translation>
    </message>
    <message>
        <source>it wrote no result</source>
        <translation>es hat kein Ergebnis geschrieben</translation>
    </message>
    <message>
        <source>its result cannot be read</source>
        <translation>sein Ergebnis lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>its result is no file</source>
        <translation>sein Ergebnis ist keine Datei</translation>
    </message>
    <message>
        <source>its result is too large</source>
        <translation>sein Ergebnis ist zu groß</translation>
    </message>
    <message>
        <source>its result is empty</source>
        <translation>sein Ergebnis ist leer</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected. Select strokes first.</source>
        <translation>Nichts Sichtbares und Entsperrtes ist ausgewählt. Wählen Sie zuerst Striche aus.</translation>
    </message>
    <message>
        <source>Nothing in the layer is visible and unlocked.</source>
        <translation>In der Ebene ist nichts sichtbar und entsperrt.</translation>
    </message>
    <message>
        <source>No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>Es lässt sich kein temporärer Ordner anlegen: %1. Setzen Sie TMPDIR auf einen beschreibbaren Ordner.</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is the disk full?</source>
        <translation>%1: lässt sich nicht schreiben (%2). Ist die Platte voll?</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2.</source>
        <translation>Das Programm %1 lässt sich nicht starten: %2.</translation>
    </message>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>Es wurde nach %n Sekunde beendet; länger darf es nicht dauern.</numerusform>
            <numerusform>Es wurde nach %n Sekunden beendet; länger darf es nicht dauern.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was ended, since it took more than %1 MB of memory.</source>
        <translation>Es wurde beendet, da es mehr als %1 MB Speicher nahm.</translation>
    </message>
    <message>
        <source>It was ended, since it wrote more than %1 MB.</source>
        <translation>Es wurde beendet, da es mehr als %1 MB schrieb.</translation>
    </message>
    <message>
        <source>The program was killed or crashed. The painting is as it was.</source>
        <translation>Das Programm wurde abgebrochen oder ist abgestürzt. Das Bild ist, wie es war.</translation>
    </message>
    <message>
        <source>The program failed (exit code %1). The painting is as it was.</source>
        <translation>Das Programm ist gescheitert (Exit-Code %1). Das Bild ist, wie es war.</translation>
    </message>
    <message>
        <source>It wrote: %1</source>
        <translation>Es schrieb: %1</translation>
    </message>
    <message>
        <source>Its result is not used, and the painting is as it was: %1.</source>
        <translation>Sein Ergebnis wird nicht verwendet, und das Bild ist, wie es war: %1.</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 wurde nicht geschrieben: %2.</translation>
    </message>
    <message>
        <source>a colour is red, yellow, blue and opacity, each from 0 to 1</source>
        <translation>eine Farbe ist Rot, Gelb, Blau und Deckkraft, je von 0 bis 1</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>geben Sie eine Zahl an</translation>
    </message>
    <message>
        <source>%1 is not in [%2, %3]</source>
        <translation>%1 liegt nicht in [%2, %3]</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>“%1” is none of %2</source>
        <translation>„%1“ ist keines von %2</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>geben Sie true oder false an</translation>
    </message>
    <message>
        <source>give a text of at most %1 characters</source>
        <translation>geben Sie einen Text von höchstens %1 Zeichen an</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>%1: the name must end with .%2</source>
        <translation>%1: Der Name muss auf .%2 enden</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: Eine solche Datei gibt es nicht</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: Einen solchen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>“%1” is neither true nor false</source>
        <translation>„%1“ ist weder true noch false</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is larger than 1 MB</source>
        <translation>%1: lässt sich nicht lesen oder ist größer als 1 MB</translation>
    </message>
    <message>
        <source>%1: %2 has the id “%3”, too; give it another one</source>
        <translation>%1: Auch %2 hat die Kennung „%3“; geben Sie ihr eine andere</translation>
    </message>
    <message>
        <source>Python 3 is missing. Install python3.</source>
        <translation>Python 3 fehlt. Installieren Sie python3.</translation>
    </message>
    <message>
        <source>The program %1 is missing, or cannot be started. Install it.</source>
        <translation>Das Programm %1 fehlt oder lässt sich nicht starten. Installieren Sie es.</translation>
    </message>
    <message>
        <source>%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and python3-numpy, or by pip as docs/python.md says.</source>
        <translation>%1 findet die Python-Module %2 nicht. Installieren Sie sie durch Pakete wie python3-suffuse und python3-numpy oder durch pip, wie docs/python.md sagt.</translation>
    </message>
    <message>
        <source>name the program, and what it is started with</source>
        <translation>nennen Sie das Programm und womit es gestartet wird</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>“%1” is not “%2”</source>
        <translation>„%1“ ist nicht „%2“</translation>
    </message>
    <message>
        <source>version %1 is not known; this program reads version %2</source>
        <translation>Version %1 ist nicht bekannt; dieses Programm liest Version %2</translation>
    </message>
    <message>
        <source>“%1” does not look like %2</source>
        <translation>„%1“ sieht nicht aus wie %2</translation>
    </message>
    <message>
        <source>a text has 1 to 2000 characters</source>
        <translation>ein Text hat 1 bis 2000 Zeichen</translation>
    </message>
    <message>
        <source>give a text, or one for each language</source>
        <translation>geben Sie einen Text an, oder einen für jede Sprache</translation>
    </message>
    <message>
        <source>give at most %1 texts of 1 to 4096 characters</source>
        <translation>geben Sie höchstens %1 Texte von 1 bis 4096 Zeichen an</translation>
    </message>
    <message>
        <source>there are at most 3 submenus within each other</source>
        <translation>es gibt höchstens 3 Untermenüs ineinander</translation>
    </message>
    <message>
        <source>there are at most %1 fields</source>
        <translation>es gibt höchstens %1 Felder</translation>
    </message>
    <message>
        <source>two fields are called %1</source>
        <translation>zwei Felder heißen %1</translation>
    </message>
    <message>
        <source>the field&apos;s type must stand before its default</source>
        <translation>die Art des Felds (type) muss vor seinem Wert (default) stehen</translation>
    </message>
    <message>
        <source>there are at most %1 choices</source>
        <translation>es gibt höchstens %1 Möglichkeiten</translation>
    </message>
    <message>
        <source>is not above least</source>
        <translation>ist nicht größer als least</translation>
    </message>
    <message>
        <source>whole numbers are from -1000000000 to 1000000000</source>
        <translation>ganze Zahlen gehen von -1000000000 bis 1000000000</translation>
    </message>
    <message>
        <source>“%1” is no ending; give it without its dot</source>
        <translation>„%1“ ist keine Endung; geben Sie sie ohne Punkt an</translation>
    </message>
    <message>
        <source>a part of the painting was passed, so canvas, palette and underlay must stay as they are</source>
        <translation>ein Teil des Bildes wurde übergeben, daher müssen Leinwand, Palette und Unterlage bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Es wurde angehalten.</translation>
    </message>
    <message>
        <source>It went well.</source>
        <translation>Es ist gelungen.</translation>
    </message>
    <message>
        <source>The result does not fit into memory.</source>
        <translation>Das Ergebnis passt nicht in den Speicher.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionDialog</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ausführen</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>Was sie jetzt enthält, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>It was stopped. The painting is as it was.</source>
        <translation>Es wurde angehalten. Das Bild ist, wie es war.</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile, so the result is not used. Run it again.</source>
        <translation>Das Bild hat sich inzwischen geändert, daher wird das Ergebnis nicht verwendet. Führen Sie es noch einmal aus.</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionFields</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen …</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Ordner und Namen wählen</translation>
    </message>
</context>
<context>
    <name>suffuse::ManageExtensionsDialog</name>
    <message>
        <source>Manage Extensions</source>
        <translation>Erweiterungen verwalten</translation>
    </message>
    <message>
        <source>Extensions</source>
        <translation>Erweiterungen</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Erweiterung</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>About the extension</source>
        <translation>Über die Erweiterung</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>Your own extensions lie there, each in a folder with a manifest</source>
        <translation>Ihre eigenen Erweiterungen liegen dort, jede in einem Ordner mit einem Manifest</translation>
    </message>
    <message>
        <source>Read &amp;Again</source>
        <translation>&amp;Neu lesen</translation>
    </message>
    <message>
        <source>Looks for extensions anew, after files were changed</source>
        <translation>Sucht neu nach Erweiterungen, nachdem Dateien geändert wurden</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Ihnen</translation>
    </message>
    <message>
        <source>Suffuse</source>
        <translation>Suffuse</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>Nicht zu gebrauchen</translation>
    </message>
    <message>
        <source>There are no extensions yet. Put a folder with a manifest into yours.</source>
        <translation>Es gibt noch keine Erweiterungen. Legen Sie einen Ordner mit einem Manifest in Ihren.</translation>
    </message>
    <message>
        <source>It uses the network.</source>
        <translation>Sie benutzt das Netz.</translation>
    </message>
    <message>
        <source>The last run: %1</source>
        <translation>Der letzte Lauf: %1</translation>
    </message>
    <message>
        <source>Your extensions lie in %1.</source>
        <translation>Ihre Erweiterungen liegen in %1.</translation>
    </message>
    <message>
        <source>What the chosen extension does, what is wrong with it, and what it wrote when it last ran</source>
        <translation>Was die gewählte Erweiterung tut, was an ihr nicht stimmt, und was sie beim letzten Lauf geschrieben hat</translation>
    </message>
    <message>
        <source>Those that are checked stand in the menu</source>
        <translation>Die angekreuzten stehen im Menü</translation>
    </message>
</context>
<context>
    <name>ColourWords</name>
    <message>
        <source>dark red</source>
        <translation>dunkelrot</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>light red</source>
        <translation>hellrot</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>braun</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>light orange</source>
        <translation>hellorange</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>oliv</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>gelb</translation>
    </message>
    <message>
        <source>light yellow</source>
        <translation>hellgelb</translation>
    </message>
    <message>
        <source>dark yellow-green</source>
        <translation>dunkelgelbgrün</translation>
    </message>
    <message>
        <source>yellow-green</source>
        <translation>gelbgrün</translation>
    </message>
    <message>
        <source>light yellow-green</source>
        <translation>hellgelbgrün</translation>
    </message>
    <message>
        <source>dark green</source>
        <translation>dunkelgrün</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grün</translation>
    </message>
    <message>
        <source>light green</source>
        <translation>hellgrün</translation>
    </message>
    <message>
        <source>dark turquoise</source>
        <translation>dunkeltürkis</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>türkis</translation>
    </message>
    <message>
        <source>light turquoise</source>
        <translation>helltürkis</translation>
    </message>
    <message>
        <source>dark blue</source>
        <translation>dunkelblau</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>hellblau</translation>
    </message>
    <message>
        <source>dark violet</source>
        <translation>dunkelviolett</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>violett</translation>
    </message>
    <message>
        <source>light violet</source>
        <translation>hellviolett</translation>
    </message>
    <message>
        <source>dark magenta</source>
        <translation>dunkelmagenta</translation>
    </message>
    <message>
        <source>magenta</source>
        <translation>magenta</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rosa</translation>
    </message>
    <message>
        <source>black</source>
        <translation>schwarz</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>dunkelgrau</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>light grey</source>
        <translation>hellgrau</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
</context>
<context>
    <name>SpokenNames</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>More buttons</source>
        <translation>Weitere Schaltflächen</translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message>
        <source>stroke %1</source>
        <translation>Strich %1</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>feathered</source>
        <translation>weich auslaufend</translation>
    </message>
    <message>
        <source>dark edge</source>
        <translation>dunkler Rand</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1 and other colours</source>
        <translation>%1 und andere Farben</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>gefüllt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln Segment</numerusform>
            <numerusform>%Ln Segmente</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln Strich</numerusform>
            <numerusform>%Ln Striche</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>%Ln ausgewählt</numerusform>
            <numerusform>%Ln ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Selects this and nothing else</source>
        <translation>Wählt dies aus und sonst nichts</translation>
    </message>
    <message>
        <source>Adds this to the selection, or takes it away</source>
        <translation>Nimmt dies in die Auswahl auf oder heraus</translation>
    </message>
</context>
<context>
    <name>suffuse::PenSpeech</name>
    <message>
        <source>Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.</source>
        <translation>Pfeiltasten bewegen den Stift, die Leertaste setzt ihn auf und hebt ihn ab. Esc legt ihn weg.</translation>
    </message>
    <message>
        <source>The pen is put away.</source>
        <translation>Der Stift ist weggelegt.</translation>
    </message>
    <message>
        <source>Pen down at %1.</source>
        <translation>Stift aufgesetzt bei %1.</translation>
    </message>
    <message>
        <source>Pen up at %1.</source>
        <translation>Stift abgehoben bei %1.</translation>
    </message>
    <message>
        <source>Pen up at %1: %2.</source>
        <translation>Stift abgehoben bei %1: %2.</translation>
    </message>
    <message>
        <source>Given up.</source>
        <translation>Aufgegeben.</translation>
    </message>
    <message>
        <source>Pressure %1 %</source>
        <translation>Druck %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>suffuse::Samples</name>
    <message>
        <source>Harbour</source>
        <translation>Hafen</translation>
    </message>
    <message>
        <source>Ink Landscape</source>
        <translation>Tuschelandschaft</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <translation>Laternen</translation>
    </message>
    <message>
        <source>Moonrise</source>
        <translation>Mondaufgang</translation>
    </message>
    <message>
        <source>Sheet of Strokes</source>
        <translation>Blatt mit Strichen</translation>
    </message>
    <message>
        <source>Still Life</source>
        <translation>Stillleben</translation>
    </message>
</context>
</TS>
