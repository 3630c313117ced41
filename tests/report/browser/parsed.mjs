/** Reads back what the page lets one download. */

/** Rows of fields of comma-separated values (RFC 4180), read strictly. */
export function parsedCsv(text) {
  const rows = [];
  let row = [],
    at = 0;
  while (at < text.length) {
    let field = '';
    if (text[at] === '"') {
      for (++at; ; ++at) {
        if (at >= text.length) throw new Error('a quoted field has no end');
        if (text[at] === '"' && text[at + 1] !== '"') break;
        if (text[at] === '"') ++at;
        field += text[at];
      }
      ++at;
    } else {
      while (at < text.length && text[at] !== ',' && text[at] !== '\r') field += text[at++];
      if (/["\n]/.test(field)) throw new Error(`the field ${field} should have been quoted`);
    }
    row.push(field);
    if (text[at] === ',') {
      ++at;
      if (at === text.length) throw new Error('the last line has no end');
    } else if (text.startsWith('\r\n', at)) {
      at += 2;
      rows.push(row);
      row = [];
    } else {
      throw new Error(`what follows a field at ${at} is neither a comma nor the end of the line`);
    }
  }
  return rows;
}

/** Width and height from the head of a PNG file. */
export function pngSize(bytes) {
  if (bytes.subarray(1, 4).toString('latin1') !== 'PNG') throw new Error('not a PNG file');
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}
