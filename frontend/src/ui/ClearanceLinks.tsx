interface ClearanceLinksProps {
  /** The pack's own address, or the project's. */
  path: string
  query?: string
  /** What the sheet is of. */
  of: string
}

/** The clearance sheet of a pack, to take along. */
export function ClearanceLinks({ path, query = '', of }: ClearanceLinksProps) {
  return (
    <p className="row small mid wrap">
      Clearance sheet
      {(['xlsx', 'pdf'] as const).map((ending) => (
        <a
          key={ending}
          className="link"
          href={`${path}/clearance-sheet.${ending}${query}`}
          download
          aria-label={`Clearance sheet of ${of} as ${ending.toUpperCase()}`}
        >
          {ending.toUpperCase()}
        </a>
      ))}
    </p>
  )
}
