import { useTitle } from '@/app/title'

/** Every part in its states, for those who build. */
export function PartsPage() {
  useTitle('Parts')
  return (
    <div className="page">
      <h1>Parts</h1>
    </div>
  )
}
