/** One file with its place in the folder it was dropped in. */
export interface Picked {
  file: File
  path: string
}

/** Files that systems leave in folders, not meant for delivery. */
export function isClutter(path: string): boolean {
  return path.split('/').some((part) => part.startsWith('.') || ['__MACOSX', 'Thumbs.db', 'desktop.ini'].includes(part))
}

/** Every file of a drop, folders walked through to the end. Call it within the event: later the list is empty. */
export async function filesOfDrop(transfer: DataTransfer): Promise<Picked[]> {
  const items = [...transfer.items]
  const taken = items.map((item) => {
    const entry = item.webkitGetAsEntry()
    if (entry?.isDirectory) return walk(entry)
    // At hand at once, while asking a thousand entries for their files takes a second.
    const file = item.getAsFile()
    return Promise.resolve(file ? [{ file, path: file.name }] : [])
  })
  const plain = [...transfer.files].map((file) => ({ file, path: file.name }))
  const picked = items.length > 0 ? (await Promise.all(taken)).flat() : plain
  return picked.filter(({ path }) => !isClutter(path))
}

/** Every file of a file or folder field. */
export function filesOfField(files: Iterable<File>): Picked[] {
  return [...files]
    .map((file) => ({ file, path: file.webkitRelativePath || file.name }))
    .filter(({ path }) => !isClutter(path))
}

async function walk(entry: FileSystemEntry): Promise<Picked[]> {
  const path = entry.fullPath.replace(/^\//, '')
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject))
    return [{ file, path }]
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader()
  const picked: Picked[] = []
  for (;;) {
    // A reader answers a hundred at a time, and an empty list at the end.
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject))
    if (some.length === 0) return picked
    picked.push(...(await Promise.all(some.map(walk))).flat())
  }
}
